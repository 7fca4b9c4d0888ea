// The protocol that driver and emulator of the range finder share (docs/workcell/range-finder.md).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/drivers/wire.hpp"

namespace pal::runtime::drivers::range_finder {

inline constexpr std::size_t points = 255;
/// x and z are in tenths of a millimetre; this much is added to x.
inline constexpr int x_offset = 10000;
inline constexpr LineSpeed line{3'000'000, 10};

/// A scan begins every 78 ms, and its profile is complete 76 ms later. Point i is taken at first_point + i ·
/// 76 ms / 255.
inline constexpr Time period = std::chrono::milliseconds(78);
inline constexpr Time collecting = std::chrono::milliseconds(76);
inline constexpr Time first_point = std::chrono::microseconds(50);
constexpr Time point_time(std::size_t i) {
  return first_point + collecting * static_cast<Time::rep>(i) / static_cast<Time::rep>(points);
}

/// The sum of a profile's text (Fletcher 1982, two sums modulo 255).
class Checksum {
 public:
  void add(std::string_view text) {
    for (const char c : text) {
      low_ = (low_ + static_cast<unsigned char>(c)) % 255;
      high_ = (high_ + low_) % 255;
    }
  }
  unsigned value() const { return high_ << 8 | low_; }

 private:
  unsigned low_ = 0;
  unsigned high_ = 0;
};

}  // namespace pal::runtime::drivers::range_finder
