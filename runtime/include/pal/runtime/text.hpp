// A short text as a value: what PAL calls TEXT.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

namespace pal::runtime {

/// Up to 100 characters of printable ASCII. Allocates nothing.
class Text {
 public:
  static constexpr std::size_t capacity = 100;
  /// The count of numbers of a payload that hold a text: six characters in each, the first in the lowest
  /// eight bits. Each is a whole number below 2^48, which a double holds exactly. Behind the text are zeros.
  static constexpr std::size_t slots = 17;

  constexpr Text() = default;
  /// Throws std::invalid_argument unless fits(characters).
  constexpr explicit Text(std::string_view characters) {
    if (!fits(characters)) throw std::invalid_argument("a text has up to 100 characters of printable ASCII");
    std::copy(characters.begin(), characters.end(), characters_.begin());
  }

  static constexpr bool fits(std::string_view characters) {
    return characters.size() <= capacity &&
           std::all_of(characters.begin(), characters.end(), [](char c) { return c >= ' ' && c <= '~'; });
  }

  constexpr std::string_view view() const {
    const auto end = std::find(characters_.begin(), characters_.end(), '\0');
    return {characters_.data(), static_cast<std::size_t>(end - characters_.begin())};
  }

  void pack(std::span<double, slots> numbers) const;
  /// Nothing: pack() never gives these numbers.
  static std::optional<Text> unpack(std::span<const double, slots> numbers);

  /// Compares the characters, as std::string_view does.
  friend constexpr bool operator==(const Text&, const Text&) = default;
  friend constexpr auto operator<=>(const Text&, const Text&) = default;
  friend constexpr bool operator==(const Text& text, std::string_view characters) {
    return text.view() == characters;
  }

 private:
  std::array<char, capacity> characters_{};  // behind the text: zeros
};

}  // namespace pal::runtime
