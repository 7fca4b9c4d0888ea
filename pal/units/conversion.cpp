#include "pal/units/conversion.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace pal::units {

namespace {

/// A whole number, most significant digit first, times a power of ten.
struct Decimal {
  bool negative = false;
  std::string digits;
  std::int64_t exponent = 0;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::optional<Decimal> parse(std::string_view text) {
  Decimal result;
  result.negative = text.starts_with('-');
  if (result.negative) text.remove_prefix(1);
  bool behind_point = false;
  std::size_t at = 0;
  for (; at < text.size() && (is_digit(text[at]) || (text[at] == '.' && !behind_point)); ++at) {
    if (text[at] == '.') {
      behind_point = true;
      continue;
    }
    result.digits += text[at];
    if (behind_point) --result.exponent;
  }
  if (result.digits.empty()) return std::nullopt;
  if (at == text.size()) return result;
  if (text[at] != 'e' && text[at] != 'E') return std::nullopt;
  text.remove_prefix(at + 1);
  if (text.starts_with('+')) text.remove_prefix(1);
  int exponent = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  result.exponent += exponent;
  return result;
}

std::string times(const std::string& digits, std::uint64_t factor) {
  std::string reversed;
  std::uint64_t carry = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    carry += static_cast<std::uint64_t>(*digit - '0') * factor;
    reversed += static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  for (; carry != 0; carry /= 10) reversed += static_cast<char>('0' + carry % 10);
  std::reverse(reversed.begin(), reversed.end());
  return reversed;
}

/// The quotient, with enough digits that no double lies between it and the true one. A last digit above 0
/// stands for what is left over. A point between two doubles has at most 767 digits.
Decimal divided(Decimal number, std::uint64_t by) {
  constexpr std::size_t enough = 800;
  std::string quotient;
  std::uint64_t rest = 0;
  const auto add = [&](std::uint64_t digit) {
    rest = rest * 10 + digit;
    const auto next = rest / by;
    rest %= by;
    if (next != 0 || !quotient.empty()) quotient += static_cast<char>('0' + next);
  };
  for (const char digit : number.digits) add(static_cast<std::uint64_t>(digit - '0'));
  while (rest != 0 && quotient.size() < enough) {
    add(0);
    --number.exponent;
  }
  if (rest != 0) {
    quotient += '1';
    --number.exponent;
  }
  number.digits = quotient.empty() ? "0" : quotient;
  return number;
}

}  // namespace

std::optional<double> converted(std::string_view decimal, const Ratio& factor) {
  constexpr std::int64_t most = 1'000'000'000'000'000'000;
  auto number = parse(decimal);
  if (!number || factor.over < 0 || factor.over > most || factor.under > most) return std::nullopt;
  number->digits = times(number->digits, static_cast<std::uint64_t>(factor.over));
  const auto exact = divided(*number, static_cast<std::uint64_t>(factor.under));
  const auto text = (exact.negative ? "-" : "") + exact.digits + "e" + std::to_string(exact.exponent);
  double result = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error == std::errc{}) return result;
  // Out of range: nearer to 0 than any double, or too great for one.
  const bool small = static_cast<std::int64_t>(exact.digits.size()) + exact.exponent < 0;
  return small ? std::optional<double>(0.0) : std::nullopt;
}

}  // namespace pal::units
