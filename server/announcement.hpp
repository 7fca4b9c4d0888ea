// How a program finds the server and its token: a file that only its user can read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "server/session.hpp"

namespace pal::server {

struct Announcement {
  std::string address;
  std::uint16_t port = 0;
  Tokens tokens;
};

/// $XDG_RUNTIME_DIR/workcell-CELL-PORT.json, or in /tmp/workcell-UID: no two servers of a machine share it.
std::string default_announcement(const std::string& cell, std::uint16_t port);
/// Those of the usual places whose servers listen, sorted. Files of servers that were killed are passed over.
std::vector<std::string> announced_servers();

/// Makes the file, and its folder if that is not there, so that others cannot read it. What was there before
/// is replaced, unless the server that it announces still listens. Throws std::runtime_error: it cannot be
/// made, the folder belongs to another user, or another server has it.
void announce(const std::string& path, const Announcement& announcement);
/// Removes the file, if it still announces this server.
void withdraw(const std::string& path, const Announcement& announcement);

/// Throws std::runtime_error: it is not there, is no announcement, or others can read it.
Announcement read_announcement(const std::string& path);

}  // namespace pal::server
