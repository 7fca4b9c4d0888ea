#include "pal/runtime/text.hpp"

#include <cmath>
#include <cstdint>

namespace pal::runtime {

namespace {
constexpr std::size_t in_a_slot = 6;
static_assert((Text::capacity + in_a_slot - 1) / in_a_slot == Text::slots);
constexpr double above_all = 281474976710656.0;  // 2^48
}  // namespace

void Text::pack(std::span<double, slots> numbers) const {
  for (std::size_t slot = 0; slot < slots; ++slot) {
    std::uint64_t bits = 0;
    const std::size_t begin = slot * in_a_slot;
    for (std::size_t i = std::min(begin + in_a_slot, capacity); i-- > begin;)
      bits = bits << 8 | static_cast<unsigned char>(characters_[i]);
    numbers[slot] = static_cast<double>(bits);
  }
}

std::optional<Text> Text::unpack(std::span<const double, slots> numbers) {
  std::array<char, capacity> characters{};
  for (std::size_t slot = 0; slot < slots; ++slot) {
    const double number = numbers[slot];
    const bool whole = number >= 0 && number < above_all && number == std::floor(number);  // false for NaN
    if (!whole) return std::nullopt;
    auto bits = static_cast<std::uint64_t>(number);
    const std::size_t begin = slot * in_a_slot;
    for (std::size_t i = begin; i < std::min(begin + in_a_slot, capacity); ++i, bits >>= 8)
      characters[i] = static_cast<char>(bits & 0xff);
    if (bits != 0) return std::nullopt;  // characters behind the longest text
  }
  const auto* end = std::find(characters.begin(), characters.end(), '\0');
  const std::string_view text{characters.data(), static_cast<std::size_t>(end - characters.begin())};
  const bool zeros = std::all_of(end, characters.cend(), [](char c) { return c == '\0'; });
  if (!zeros || !fits(text)) return std::nullopt;
  return Text(text);
}

}  // namespace pal::runtime
