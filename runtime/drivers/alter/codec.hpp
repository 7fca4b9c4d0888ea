// The frames of the ALTER line (docs/workcell/alter.md): values in, bytes out, and back. No clock.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runtime/drivers/alter/protocol.hpp"
#include "runtime/drivers/link.hpp"
#include "runtime/drivers/wire.hpp"

namespace pal::runtime::drivers::alter {

inline constexpr LineSpeed line{115200, 10};

/// x, y, z in mm and rx, ry, rz in degrees: a turn about x, then y, then z.
using Figures = std::array<double, 6>;

/// From the controller at the beginning of each cycle.
struct Request {
  std::uint8_t cycle = 0;
  bool moving = false;
  Figures position{};  // of the tool's tip in frame 0

  friend bool operator==(const Request&, const Request&) = default;
};

/// To the controller, once a cycle. Without `motion` the figures mean nothing.
struct Answer {
  std::uint8_t cycle = 0;  // of the request
  bool motion = false;
  Figures correction{};

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// From the controller: there are no more requests, and the arm stands still.
struct Ended {
  enum class Reason : std::uint8_t { closed = 0, late = 1, unasked = 2, impossible = 3, arm_fault = 4 };
  Reason reason = Reason::closed;
  std::string text;  // at most 120 characters of ASCII; the rest is cut off

  friend bool operator==(const Ended&, const Ended&) = default;
};

using Frame = std::variant<Request, Answer, Ended>;

/// Figures are rounded to the resolution; what is out of range becomes the end of the range.
std::vector<std::uint8_t> encode(const Frame& frame);

/// Bytes that are no frame, and why.
struct Garbled {
  std::string why;
};

/// Finds frames in the bytes that come in, however they are cut. After garbled bytes it goes on with the next
/// start byte.
class Decoder {
 public:
  void feed(Bytes bytes);
  /// The next frame that is complete; nothing: none is.
  std::optional<std::variant<Frame, Garbled>> next();
  void forget() { bytes_.clear(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace pal::runtime::drivers::alter
