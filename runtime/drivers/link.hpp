// Bytes between a driver and the device that it drives.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pal::runtime::drivers {

using Bytes = std::span<const std::uint8_t>;

/// The user of one end of a link.
class LinkUser {
 public:
  virtual ~LinkUser() = default;

  /// Bytes have arrived, at the time of the station's clock. How they are cut into calls has no meaning.
  virtual void on_bytes(Bytes bytes) = 0;
  /// The link is broken: unplugged, closed at the other end, or failed. No bytes come any more.
  virtual void on_break(std::string_view reason) = 0;
};

/// One end of a line that carries bytes both ways. The opener of a link gives it to its user; both outlive
/// their last use of each other.
class Link {
 public:
  virtual ~Link() = default;

  /// From now on `user` gets the bytes that arrive; null: they are dropped.
  virtual void connect(LinkUser* user) = 0;
  /// Sends; returns at once. On a broken link nothing happens.
  virtual void write(Bytes bytes) = 0;
};

inline Bytes as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string_view as_text(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace pal::runtime::drivers
