// The values of a figure: a range of times or whole numbers, and random picks of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pal::study {

/// The most values of one figure.
constexpr std::uint64_t most_values = 100'000;

/// As written: times ("20 ms") or whole numbers ("3"). One of `step` and `count` is given.
struct Range {
  std::string from;
  std::string to;
  std::optional<std::string> step;
  std::optional<std::int64_t> count;   // of values, both ends included
  std::optional<std::int64_t> random;  // so many of them, each once, in order
  std::uint64_t seed = 0;
};

/// The values in order, or what is wrong. The same seed picks the same values on every machine.
std::variant<std::vector<std::string>, std::string> values_of(const Range& range);

}  // namespace pal::study
