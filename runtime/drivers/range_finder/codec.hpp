// The range finder's protocol, without a clock.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/drivers/range_finder/protocol.hpp"

namespace pal::runtime::drivers::range_finder {

struct Profile {
  std::array<double, points> x{};  // mm along the tool's y axis
  std::array<double, points> z{};  // mm from the range finder
  std::array<bool, points> valid{};
  std::int64_t began = 0;  // of the scan, µs by the range finder's clock
};

/// What comes from the range finder, byte by byte.
class Codec {
 public:
  enum class Event {
    none,
    ready,    // it has been started; ready_at() is what its clock said
    began,    // of a profile, which answers answers() requests
    profile,  // one is complete
    garbled,  // what came is not in the protocol: problem() says why
  };

  /// Takes nothing but the line that ends a start.
  void expect_ready();

  Event feed(std::uint8_t byte);
  const Profile& profile() const { return profile_; }
  int answers() const { return answers_; }
  std::int64_t ready_at() const { return ready_at_; }
  const std::string& problem() const { return problem_; }
  /// What has come of a profile: "only 12 of its 255 points came"; empty: nothing.
  std::string missing() const;

 private:
  enum class State { starting, between, point, end };

  Event take_line();
  Event take_ready();
  Event take_header();
  Event take_point();
  Event take_end();
  Event garble(std::string problem);

  State state_ = State::starting;
  std::string line_;
  std::size_t count_ = 0;
  Checksum sum_;
  Profile profile_;
  int answers_ = 0;
  std::int64_t ready_at_ = 0;
  std::string problem_;
};

}  // namespace pal::runtime::drivers::range_finder
