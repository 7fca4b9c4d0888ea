// Draws that are the same on every machine for the same seed (the standard leaves its distributions open).
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "pal/runtime/device.hpp"

namespace pal::sim {

class Random {
 public:
  /// `stream` keeps users of one seed apart.
  Random(std::uint64_t seed, std::uint64_t stream)
      : engine_(mix(seed + 0x9e3779b97f4a7c15ULL * (stream + 1))) {}

  /// In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

  /// A whole number of nanoseconds, both ends possible. Contract: best <= worst.
  runtime::Time between(runtime::Time best, runtime::Time worst) {
    const auto span = static_cast<double>((worst - best).count() + 1);
    return best + runtime::Time(static_cast<std::int64_t>(unit() * span));
  }

  /// Mean 0, deviation 1 (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
    return radius * std::cos(2.0 * std::numbers::pi * unit());
  }

 private:
  // Neighbouring seeds must give unlike streams (splitmix64's finaliser).
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }

  std::mt19937_64 engine_;
};

}  // namespace pal::sim
