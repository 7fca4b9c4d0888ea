// The serial protocol of the ATI force-torque sensor (docs/workcell/force-torque.md), without a clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/drivers/link.hpp"

namespace pal::runtime::drivers::force_torque {

inline constexpr std::uint8_t one_record = 0x14;  // control T
inline constexpr std::uint8_t warm_boot = 0x17;   // control W
inline constexpr std::uint8_t carriage_return = 0x0d;
inline constexpr std::size_t axes = 6;  // fx fy fz tx ty tz
inline constexpr std::size_t record_size =
    1 + 2 * axes;  // overload byte, then high and low byte of each axis
inline constexpr double counts_per_newton = 20;
inline constexpr double counts_per_newton_metre = 333.33;
/// The end of the sensor's range, in counts: 65 N, 5 N*m. The value of an overloaded axis stays there.
inline constexpr int greatest_force = 1300;
inline constexpr int greatest_torque = 1667;
inline constexpr double force_range = 65;  // N
inline constexpr double torque_range = 5;  // N*m

struct Record {
  bool overload = false;
  std::array<int, axes> counts{};

  /// The wrench in N and N*m.
  std::array<double, axes> values() const;
};

/// Reads what comes from the sensor, byte by byte. One question at a time: each function says what to write,
/// and feed() then reads its answer.
class Codec {
 public:
  enum class Progress {
    more,     // the answer is not complete
    done,     // it is
    garbled,  // it is not what the protocol has: problem() says why. No question is open then.
  };

  /// ^W: anything may come before the prompt.
  Bytes boot();
  /// A line of text without its end. Each character comes back, then the sensor's answer, then the prompt.
  Bytes command(std::string_view text);
  /// ^T: its echo, if the sensor sends one, and a record of all six axes.
  Bytes request_record();

  Progress feed(std::uint8_t byte);
  const Record& record() const { return record_; }
  /// What is awaited, and how much of it has come: "only 7 of the 13 bytes of a record came".
  std::string missing() const;
  const std::string& problem() const { return problem_; }
  bool asking() const { return question_ != Question::none; }
  /// Forgets the open question.
  void forget() { question_ = Question::none; }

 private:
  enum class Question { none, boot, echo, prompt, record };

  Progress feed_echo(std::uint8_t byte);
  Progress feed_prompt(std::uint8_t byte);
  Progress feed_record(std::uint8_t byte);
  Progress garble(std::string problem);

  Question question_ = Question::none;
  std::string sent_;    // of a command: with its end
  std::string answer_;  // of a command: what came between echo and prompt
  std::size_t received_ = 0;
  bool echoed_ = false;  // of ^T
  std::array<std::uint8_t, record_size> bytes_{};
  Record record_;
  std::string problem_;
};

}  // namespace pal::runtime::drivers::force_torque
