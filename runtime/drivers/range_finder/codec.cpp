#include "runtime/drivers/range_finder/codec.hpp"

#include <cinttypes>
#include <cstdio>
#include <utility>

#include "runtime/drivers/linked_driver.hpp"

namespace pal::runtime::drivers::range_finder {
namespace {

constexpr std::size_t longest_line = 40;
constexpr std::string_view invalid_point = "----- -----";

}  // namespace

void Codec::expect_ready() {
  state_ = State::starting;
  line_.clear();
}

Codec::Event Codec::feed(std::uint8_t byte) {
  if (byte != '\n') {
    // Of a profile that a start cut off some may still come, and not be lines.
    if (line_.size() < longest_line || state_ == State::starting) {
      line_ += static_cast<char>(byte);
      return Event::none;
    }
    return garble("sends a line without end: " + shown(as_bytes(line_)));
  }
  const Event event = take_line();
  line_.clear();
  return event;
}

Codec::Event Codec::take_line() {
  if (line_.empty() || line_.back() != '\r') {
    if (state_ == State::starting) return Event::none;
    return garble("sends " + shown(as_bytes(line_)) + ", which is no line of its protocol");
  }
  line_.pop_back();
  switch (state_) {
    case State::starting:
      return take_ready();
    case State::between:
      return take_header();
    case State::point:
      return take_point();
    case State::end:
      return take_end();
  }
  return Event::none;
}

Codec::Event Codec::take_ready() {
  int length = 0;
  if (std::sscanf(line_.c_str(), "READY 255 %10" SCNd64 "%n", &ready_at_, &length) != 1 ||
      static_cast<std::size_t>(length) != line_.size()) {
    return Event::none;
  }
  state_ = State::between;
  return Event::ready;
}

Codec::Event Codec::take_header() {
  int length = 0;
  if (std::sscanf(line_.c_str(), "PROFILE %2d %10" SCNd64 "%n", &answers_, &profile_.began, &length) != 2 ||
      static_cast<std::size_t>(length) != line_.size() || answers_ < 1) {
    return garble("sends \"" + line_ + "\" where a profile should begin");
  }
  sum_ = {};
  sum_.add(line_);
  count_ = 0;
  state_ = State::point;
  return Event::began;
}

Codec::Event Codec::take_point() {
  int x = x_offset;
  int z = 0;
  int length = 0;
  const bool invalid = line_ == invalid_point;
  if (!invalid &&
      (std::sscanf(line_.c_str(), "%5d %5d%n", &x, &z, &length) != 2 || length != 11 || line_.size() != 11)) {
    return garble("sends \"" + line_ + "\" as point " + std::to_string(count_) + " of a profile");
  }
  profile_.x[count_] = (x - x_offset) / 10.0;
  profile_.z[count_] = z / 10.0;
  profile_.valid[count_] = !invalid;
  sum_.add(line_);
  if (++count_ == points) state_ = State::end;
  return Event::none;
}

Codec::Event Codec::take_end() {
  unsigned sum = 0;
  int length = 0;
  if (std::sscanf(line_.c_str(), "END %4x%n", &sum, &length) != 1 || length != 8 || line_.size() != 8) {
    return garble("sends \"" + line_ + "\" where a profile should end");
  }
  if (sum != sum_.value()) return garble("sends a profile whose check sum is wrong");
  state_ = State::between;
  return Event::profile;
}

std::string Codec::missing() const {
  if (state_ == State::end) return "a profile without its end came";
  if (state_ != State::point) return {};
  return "only " + std::to_string(count_) + " of the 255 points of a profile came";
}

Codec::Event Codec::garble(std::string problem) {
  problem_ = std::move(problem);
  return Event::garbled;
}

}  // namespace pal::runtime::drivers::range_finder
