// The content of a message, as a flat list of numbers: the fields one after the other, an array value by
// value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pal/runtime/text.hpp"
#include "pal/runtime/whole.hpp"

namespace pal::runtime {

/// How a value of a field stands in a payload: as a number (a boolean as 0 or 1), or as a packed Text.
enum class FieldKind { number, text };

/// So many numbers of a payload hold `count` values of this kind.
constexpr std::size_t slots_of(FieldKind kind, std::size_t count) {
  return kind == FieldKind::text ? count * Text::slots : count;
}

/// put() writes a value from number `at` on; get() reads it back. The numbers must be there.
inline void put(double value, std::span<double> numbers, std::size_t at) {
  numbers[at] = finite(value);
}
inline void put(std::int64_t value, std::span<double> numbers, std::size_t at) {
  numbers[at] = from_whole(value);
}
inline void put(bool value, std::span<double> numbers, std::size_t at) {
  numbers[at] = value ? 1.0 : 0.0;
}
inline void put(const Text& value, std::span<double> numbers, std::size_t at) {
  value.pack(numbers.subspan(at).first<Text::slots>());
}

inline void get(double& value, std::span<const double> numbers, std::size_t at) {
  value = finite(numbers[at]);
}
inline void get(std::int64_t& value, std::span<const double> numbers, std::size_t at) {
  value = whole(numbers[at]);
}
inline void get(bool& value, std::span<const double> numbers, std::size_t at) {
  value = truth(numbers[at]);
}
/// Throws std::bad_optional_access if the numbers are not a text. Numbers of messages are, because what a
/// device delivers is checked on its way in.
inline void get(Text& value, std::span<const double> numbers, std::size_t at) {
  value = Text::unpack(numbers.subspan(at).first<Text::slots>()).value();
}

/// An array of numbers or booleans.
template <class Value, std::size_t count>
void put(const std::array<Value, count>& values, std::span<double> numbers, std::size_t at) {
  for (std::size_t i = 0; i < count; ++i) put(values[i], numbers, at + i);
}
template <class Value, std::size_t count>
void get(std::array<Value, count>& values, std::span<const double> numbers, std::size_t at) {
  for (std::size_t i = 0; i < count; ++i) get(values[i], numbers, at + i);
}

}  // namespace pal::runtime
