// What a person holds to move the arm, as the desk hands on its orders.
#pragma once

#include <array>
#include <string_view>

namespace pal::server {

/// The skill by which a person moves the arm: it acts while orders come.
inline constexpr std::string_view skill_by_hand = "jog";

/// How fast each of six axes is to go, of the speed that was set: from -1 to 1.
using JogAxes = std::array<double, 6>;

/// The cell's side. From any thread.
class Pendant {
 public:
  virtual ~Pendant() = default;
  /// `held`: false, the button was released. The arm stops by itself when no order comes.
  virtual void order(const JogAxes& axes, bool held) = 0;
};

}  // namespace pal::server
