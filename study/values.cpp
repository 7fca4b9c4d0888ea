#include "study/values.hpp"

#include <charconv>
#include <random>
#include <set>

#include "pal/support/duration_text.hpp"

namespace pal::study {
namespace {

struct Number {
  std::int64_t value = 0;
  bool time = false;
};

std::optional<Number> number_of(const std::string& text) {
  std::int64_t whole = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), whole);
  if (error == std::errc() && end == text.data() + text.size()) return Number{whole, false};
  const auto digits = text.find_last_of("0123456789.");
  if (digits == std::string::npos) return std::nullopt;
  const auto unit = text.find_first_not_of(' ', digits + 1);
  if (unit == std::string::npos) return std::nullopt;
  const auto parsed = parse_duration(text.substr(0, digits + 1), text.substr(unit));
  const auto* time = std::get_if<Duration>(&parsed);
  if (time == nullptr) return std::nullopt;
  return Number{time->count(), true};
}

/// So many different ones of 0 to count - 1. Floyd's way takes no more draws than picks.
std::set<std::uint64_t> picks(std::uint64_t count, std::uint64_t wanted, std::uint64_t seed) {
  std::mt19937_64 dice(seed);
  std::set<std::uint64_t> picked;
  for (std::uint64_t last = count - wanted; last < count; ++last) {
    const std::uint64_t pick = dice() % (last + 1);  // no distribution of the library: those differ by maker
    picked.insert(picked.contains(pick) ? last : pick);
  }
  return picked;
}

std::string many(std::uint64_t values) {
  return "the range has " + std::to_string(values) + " values; a figure has at most " +
         std::to_string(most_values);
}

}  // namespace

std::variant<std::vector<std::string>, std::string> values_of(const Range& range) {
  const auto from = number_of(range.from), to = number_of(range.to);
  if (!from || !to)
    return "'" + (from ? range.to : range.from) + "' is neither a time, as \"20 ms\" is, nor a whole number";
  if (from->time != to->time) return std::string("'from' and 'to' are not both times");
  if (from->value > to->value) return "the range is empty: it goes from " + range.from + " to " + range.to;
  const std::uint64_t length =
      static_cast<std::uint64_t>(to->value) - static_cast<std::uint64_t>(from->value);
  if (range.step.has_value() == range.count.has_value())
    return std::string("a range needs one of 'step' and 'count'");
  std::uint64_t steps = 0;  // between the first value and the last
  std::uint64_t step = 0;
  if (range.step) {
    const auto given = number_of(*range.step);
    if (!given || given->time != from->time || given->value <= 0)
      return "'" + *range.step + "' is no step from " + range.from + " to " + range.to;
    step = static_cast<std::uint64_t>(given->value);
    steps = length / step;
  } else {
    if (*range.count < 1) return "the range is empty: 'count' is " + std::to_string(*range.count);
    steps = static_cast<std::uint64_t>(*range.count) - 1;
    if (*range.count > 1'000'000'000)
      return "'count' is " + std::to_string(*range.count) + "; at most 1000000000";
    if (steps > length) return std::string("there are not so many values between 'from' and 'to'");
  }
  const std::uint64_t grid = steps + 1;
  const auto value = [&](std::uint64_t index) {
    // Without overflow: index <= steps <= length. What the division leaves is spread over the values.
    const std::uint64_t offset = range.step   ? index * step
                                 : steps == 0 ? 0
                                              : length / steps * index + length % steps * index / steps;
    const std::int64_t at = from->value + static_cast<std::int64_t>(offset);
    return from->time ? to_text(Duration(at)) : std::to_string(at);
  };
  std::vector<std::string> values;
  if (range.random) {
    if (*range.random < 1) return "the range is empty: 'random' is " + std::to_string(*range.random);
    const auto wanted = static_cast<std::uint64_t>(*range.random);
    if (wanted > grid)
      return "'random' asks for " + std::to_string(wanted) + " different values, and the range has " +
             std::to_string(grid);
    if (wanted > most_values) return many(wanted);
    for (const std::uint64_t index : picks(grid, wanted, range.seed)) values.push_back(value(index));
    return values;
  }
  if (grid > most_values) return many(grid);
  for (std::uint64_t index = 0; index < grid; ++index) values.push_back(value(index));
  return values;
}

}  // namespace pal::study
