// How a program finds the server and its token: a file that only its user can read.
#pragma once

#include <cstdint>
#include <string>

namespace pal::server {

struct Announcement {
  std::string address;
  std::uint16_t port = 0;
  std::string token;
};

/// $XDG_RUNTIME_DIR/workcell.json, or /tmp/workcell-UID/workcell.json.
std::string default_announcement();

/// Makes the file, and its folder if that is not there, so that others cannot read it. What was there before
/// is replaced. Throws std::runtime_error: it cannot be made, or the folder belongs to another user.
void announce(const std::string& path, const Announcement& announcement);

/// Throws std::runtime_error: it is not there, is no announcement, or others can read it.
Announcement read_announcement(const std::string& path);

}  // namespace pal::server
