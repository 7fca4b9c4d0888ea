// Why the compositional analysis has no bound, from the one table in withheld.def.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "pal/support/placeholders.hpp"

namespace pal::analyzer::compositional {

enum class Withheld : std::uint8_t {
#define PAL_WITHHELD(name, kind, reason, why, advice) name,
#include "analyzer/compositional/causes/withheld.def"
#undef PAL_WITHHELD
};

/// A row of the table.
struct WithheldRow {
  enum class Kind { shape, gap, end };
  std::string_view name;
  Kind kind;
  std::string_view reason;
  std::string_view why;
  std::string_view advice;  // empty: there is none
};

/// By number.
inline constexpr std::array withheld_rows{
#define PAL_WITHHELD(name, kind, reason, why, advice) \
  WithheldRow{#name, WithheldRow::Kind::kind, reason, why, advice},
#include "analyzer/compositional/causes/withheld.def"
#undef PAL_WITHHELD
};

constexpr const WithheldRow& row(Withheld withheld) {
  return withheld_rows[static_cast<std::size_t>(withheld)];
}
constexpr Placeholders placeholders(Withheld withheld) {
  return placeholders_in({row(withheld).reason});
}

/// The rows that are set aside, so that a test sees the bound that would come out without them. None
/// otherwise.
class SetAside {
 public:
  SetAside() = default;
  SetAside(std::initializer_list<Withheld> rows) {
    for (const Withheld each : rows) rows_.set(static_cast<std::size_t>(each));
  }
  bool has(Withheld withheld) const { return rows_.test(static_cast<std::size_t>(withheld)); }

 private:
  std::bitset<withheld_rows.size()> rows_;
};

/// Why there is no bound; empty: there is one.
struct Why {
  std::string text;                       // for people
  std::optional<Withheld> withheld = {};  // the first reason, from which the others follow

  bool empty() const { return !withheld; }
};

/// A row with an argument for each of its placeholders.
template <class... Arguments>
Why why(std::type_identity_t<RowWith<Withheld, sizeof...(Arguments)>> withheld,
        const Arguments&... arguments) {
  return {filled(row(withheld.row).reason, placeholders(withheld.row), {argument_text(arguments)...}),
          withheld.row};
}

/// `what`, which follows from `behind`, if there is that.
inline Why since(Why what, const Why& behind) {
  return behind.empty() ? what : Why{what.text + ", since " + behind.text, behind.withheld};
}

}  // namespace pal::analyzer::compositional
