#include "pal/support/duration_text.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <limits>

namespace pal {

namespace {

struct Unit {
  std::string_view name;
  std::int64_t nanoseconds;
};

constexpr std::array units{Unit{"ns", 1}, Unit{"us", 1'000}, Unit{"ms", 1'000'000}, Unit{"s", 1'000'000'000},
                           Unit{"min", 60'000'000'000}};
constexpr std::size_t seconds = 3;  // the greatest unit that is written

const Unit* find_unit(std::string_view name) {
  for (const auto& unit : units) {
    if (unit.name == name) return &unit;
  }
  return nullptr;
}

/// A decimal number: digits x 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;  // without leading or trailing zeros; empty: zero
  std::int64_t exponent = 0;
};

std::variant<Decimal, DurationError> parse_decimal(std::string_view text) {
  Decimal result;
  if (!text.empty() && text.front() == '-') {
    result.negative = true;
    text.remove_prefix(1);
  }
  const auto mark = text.find_first_of("eE");
  if (mark != std::string_view::npos) {
    auto power = text.substr(mark + 1);
    if (!power.empty() && power.front() == '+') power.remove_prefix(1);
    const auto parsed = std::from_chars(power.data(), power.data() + power.size(), result.exponent);
    // Past this every number is zero or too large, and sums of exponents stay in range.
    constexpr std::int64_t limit = 1'000'000'000;
    if (parsed.ec == std::errc::invalid_argument) return DurationError::no_number;
    if (parsed.ec == std::errc::result_out_of_range) {
      result.exponent = power.front() == '-' ? -limit : limit;
    }
    result.exponent = result.exponent > limit ? limit : result.exponent < -limit ? -limit : result.exponent;
    text = text.substr(0, mark);
  }
  bool seen_point = false;
  bool seen_digit = false;
  for (const char c : text) {
    if (c == '.' && !seen_point) {
      seen_point = true;
    } else if (c >= '0' && c <= '9') {
      seen_digit = true;
      result.digits += c;
      if (seen_point) --result.exponent;
    } else {
      return DurationError::no_number;
    }
  }
  if (!seen_digit) return DurationError::no_number;
  while (!result.digits.empty() && result.digits.back() == '0') {
    result.digits.pop_back();
    ++result.exponent;
  }
  result.digits.erase(0, result.digits.find_first_not_of('0'));
  return result;
}

__extension__ typedef __int128 Wide;

/// `number` times `unit` nanoseconds.
std::variant<Duration, DurationError> nanoseconds(std::string_view number, std::int64_t unit) {
  const auto parsed = parse_decimal(number);
  if (const auto* error = std::get_if<DurationError>(&parsed)) return *error;
  auto [negative, digits, exponent] = std::get<Decimal>(parsed);
  if (digits.empty()) return Duration{0};

  constexpr Wide limit = std::numeric_limits<std::int64_t>::max();
  // At most 19 digits and a power of ten fit; more digits than that can only be a fraction of a nanosecond or
  // too large.
  Wide value = 0;
  for (const char c : digits) {
    value = value * 10 + (c - '0');
    if (value > limit) {
      return exponent < -11 ? DurationError::not_whole : DurationError::overflow;
    }
  }
  value *= unit;
  for (; exponent > 0; --exponent) {
    value *= 10;
    if (value > limit) return DurationError::overflow;
  }
  for (; exponent < 0; ++exponent) {
    if (value % 10 != 0) return DurationError::not_whole;
    value /= 10;
  }
  if (value > limit) return DurationError::overflow;
  const auto count = static_cast<std::int64_t>(value);
  return Duration{negative ? -count : count};
}

}  // namespace

std::variant<Duration, DurationError> parse_duration(std::string_view number, std::string_view unit_name) {
  const auto* unit = find_unit(unit_name);
  if (unit != nullptr) return nanoseconds(number, unit->nanoseconds);
  const auto parsed = parse_decimal(number);
  const auto* error = std::get_if<DurationError>(&parsed);
  return error != nullptr ? *error : DurationError::no_unit;
}

std::variant<Duration, DurationError> parse_percentage(std::string_view percent) {
  constexpr std::int64_t of_a_second = 10'000'000;
  return nanoseconds(percent, of_a_second);
}

namespace {

const Unit& unit_for(Duration value) {
  const auto count = value.count() < 0 ? -value.count() : value.count();
  if (count == 0) return units[2];
  std::size_t index = 0;
  while (index < seconds && count >= units[index + 1].nanoseconds) ++index;
  return units[index];
}

std::string in_unit(Duration value, const Unit& unit) {
  const bool negative = value.count() < 0;
  const auto count = negative ? -value.count() : value.count();
  std::string text = (negative ? "-" : "") + std::to_string(count / unit.nanoseconds);
  auto rest = count % unit.nanoseconds;
  if (rest != 0) text += '.';
  for (auto place = unit.nanoseconds / 10; rest != 0; place /= 10) {
    text += static_cast<char>('0' + rest / place);
    rest %= place;
  }
  return text;
}

}  // namespace

std::string to_text(Duration value) {
  const auto& unit = unit_for(value);
  return in_unit(value, unit) + " " + std::string(unit.name);
}

std::string to_text(const Interval& value) {
  if (value.best == value.worst) return to_text(value.worst);
  const auto& unit = unit_for(value.worst);
  return in_unit(value.best, unit) + " TO " + in_unit(value.worst, unit) + " " + std::string(unit.name);
}

}  // namespace pal
