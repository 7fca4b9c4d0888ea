#include "pal/units/unit.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace pal::units {

namespace {

struct Named {
  std::string_view name;
  Unit unit;
};

constexpr std::int64_t thousand = 1000;
constexpr std::int64_t million = 1'000'000;
constexpr std::int64_t billion = 1'000'000'000;

constexpr Dimension length{1, 0, 0, 0, 0, 0, 0};
constexpr Dimension mass{0, 1, 0, 0, 0, 0, 0};
constexpr Dimension time{0, 0, 1, 0, 0, 0, 0};
constexpr Dimension current{0, 0, 0, 1, 0, 0, 0};
constexpr Dimension temperature{0, 0, 0, 0, 1, 0, 0};
constexpr Dimension angle{0, 0, 0, 0, 0, 1, 0};
constexpr Dimension number{0, 0, 0, 0, 0, 0, 1};
constexpr Dimension volume{3, 0, 0, 0, 0, 0, 0};
constexpr Dimension frequency{0, 0, -1, 0, 0, 0, 0};
constexpr Dimension angular_speed{0, 0, -1, 0, 0, 1, 0};
constexpr Dimension force{1, 1, -2, 0, 0, 0, 0};
constexpr Dimension energy{2, 1, -2, 0, 0, 0, 0};
constexpr Dimension power{2, 1, -3, 0, 0, 0, 0};
constexpr Dimension pressure{-1, 1, -2, 0, 0, 0, 0};
constexpr Dimension voltage{2, 1, -3, -1, 0, 0, 0};

// International yard and pound of 1959: 1 in is 25.4 mm, 1 lb is 0.45359237 kg. The standard acceleration of
// gravity is 9.80665 m/s^2. Sources: BIPM, The International System of Units, and NIST SP 811, appendix B.
const std::array<Named, 48> known{{
    {"m", {length, {}, 0, true}},
    {"mm", {length, {1, thousand}, 0, true}},
    {"um", {length, {1, million}, 0, true}},
    {"cm", {length, {1, 100}, 0, true}},
    {"km", {length, {thousand, 1}, 0, true}},
    {"in", {length, {127, 5000}, 0, true}},
    {"ft", {length, {381, 1250}, 0, true}},
    {"l", {volume, {1, thousand}, 0, true}},
    {"ml", {volume, {1, million}, 0, true}},
    {"N", {force, {}, 0, true}},
    {"mN", {force, {1, thousand}, 0, true}},
    {"kN", {force, {thousand, 1}, 0, true}},
    {"kgf", {force, {196'133, 20'000}, 0, true}},
    {"lbf", {force, {8'896'443'230'521, 2'000'000'000'000}, 0, true}},
    {"kg", {mass, {}, 0, true}},
    {"g", {mass, {1, thousand}, 0, true}},
    {"lb", {mass, {45'359'237, 100'000'000}, 0, true}},
    {"s", {time, {}, 0, true}},
    {"ms", {time, {1, thousand}, 0, true}},
    {"us", {time, {1, million}, 0, true}},
    {"ns", {time, {1, billion}, 0, true}},
    {"min", {time, {60, 1}, 0, true}},
    {"h", {time, {3600, 1}, 0, true}},
    {"rad", {angle, {}, 0, true}},
    {"mrad", {angle, {1, thousand}, 0, true}},
    {"deg", {angle, {1, 180}, 1, true}},
    {"rev", {angle, {2, 1}, 1, true}},
    {"rpm", {angular_speed, {1, 30}, 1, true}},
    {"Hz", {frequency, {}, 0, true}},
    {"kHz", {frequency, {thousand, 1}, 0, true}},
    {"MHz", {frequency, {million, 1}, 0, true}},
    {"V", {voltage, {}, 0, true}},
    {"mV", {voltage, {1, thousand}, 0, true}},
    {"A", {current, {}, 0, true}},
    {"mA", {current, {1, thousand}, 0, true}},
    {"W", {power, {}, 0, true}},
    {"mW", {power, {1, thousand}, 0, true}},
    {"kW", {power, {thousand, 1}, 0, true}},
    {"J", {energy, {}, 0, true}},
    {"K", {temperature, {}, 0, true}},
    {"degC", {temperature, {}, 0, false}},
    {"Pa", {pressure, {}, 0, true}},
    {"kPa", {pressure, {thousand, 1}, 0, true}},
    {"MPa", {pressure, {million, 1}, 0, true}},
    {"bar", {pressure, {100 * thousand, 1}, 0, true}},
    {"mbar", {pressure, {100, 1}, 0, true}},
    {"psi", {pressure, {8'896'443'230'521, 1'290'320'000}, 0, true}},
    {"count", {number, {}, 0, true}},
}};

std::optional<Ratio> product(const Ratio& a, const Ratio& b) {
  // Crosswise first, so that nothing is larger on the way than in the end.
  const auto left = std::gcd(a.over, b.under);
  const auto right = std::gcd(b.over, a.under);
  Ratio result;
  if (__builtin_mul_overflow(a.over / left, b.over / right, &result.over)) return std::nullopt;
  if (__builtin_mul_overflow(a.under / right, b.under / left, &result.under)) return std::nullopt;
  return result;
}

Ratio inverse(const Ratio& ratio) {
  return {ratio.under, ratio.over};
}

/// `times` of -9 to 9.
std::optional<Unit> multiplied(Unit unit, const Unit& by, int times) {
  const auto scale = times < 0 ? inverse(by.scale) : by.scale;
  for (int i = 0; i < std::abs(times); ++i) {
    const auto next = product(unit.scale, scale);
    if (!next) return std::nullopt;
    unit.scale = *next;
  }
  for (std::size_t i = 0; i < unit.dimension.size(); ++i) unit.dimension[i] += times * by.dimension[i];
  unit.power_of_pi += times * by.power_of_pi;
  return unit;
}

const Unit* find(std::string_view name) {
  for (const auto& one : known) {
    if (one.name == name) return &one.unit;
  }
  return nullptr;
}

/// "^-2" is -2, nothing is 1, anything else is 0.
int power_of(std::string_view text) {
  if (text.empty()) return 1;
  text.remove_prefix(1);
  const bool below = text.starts_with('-');
  if (below) text.remove_prefix(1);
  if (text.size() != 1 || text[0] < '1' || text[0] > '9') return 0;
  return below ? -(text[0] - '0') : text[0] - '0';
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view spelling) {
  if (spelling == "%") return Unit{{}, {1, 100}, 0, true};
  if (const auto* alone = find(spelling)) return *alone;
  Unit result;
  int sign = 1;
  while (true) {
    const auto end = spelling.find_first_of("*/");
    const auto one = spelling.substr(0, end);
    const auto mark = std::min(one.find('^'), one.size());
    const auto* base = find(one.substr(0, mark));
    const int times = power_of(one.substr(mark));
    if (base == nullptr || times == 0) return std::nullopt;
    // In a product degC is a difference of temperatures.
    const auto next = multiplied(result, *base, sign * times);
    if (!next) return std::nullopt;
    result = *next;
    if (end == std::string_view::npos) return result;
    sign = spelling[end] == '/' ? -1 : 1;
    spelling.remove_prefix(end + 1);
  }
}

std::optional<Ratio> factor(const Unit& from, const Unit& to) {
  if (from.dimension != to.dimension || from.power_of_pi != to.power_of_pi ||
      from.from_zero != to.from_zero) {
    return std::nullopt;
  }
  return product(from.scale, inverse(to.scale));
}

std::string known_units() {
  std::string result;
  for (const auto& one : known) result += (result.empty() ? "" : ", ") + std::string(one.name);
  return result + "; or %";
}

}  // namespace pal::units
