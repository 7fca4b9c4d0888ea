// The findings by name, each with its text and hint, from the one table in diagnostic_code.def. Whoever
// reports one names it and gives the arguments of its placeholders; their number is checked when it is
// compiled.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal {

enum class Finding : std::uint16_t {
#define PAL_FINDING(code, name, text, hint) name,
#include "pal/support/diagnostic_code.def"
};

/// A row of the table.
struct FindingRow {
  std::string_view name;
  Code code;
  std::string_view text;
  std::string_view hint;  // empty: there is none
};

/// All rows; a finding is its row's number.
inline constexpr std::array finding_rows{
#define PAL_FINDING(code, name, text, hint) FindingRow{#name, Code::code, text, hint},
#include "pal/support/diagnostic_code.def"
};

constexpr const FindingRow& row(Finding finding) {
  return finding_rows[static_cast<std::size_t>(finding)];
}

/// The first placeholder in `text`, with its braces, as in "{module}"; empty if there is none.
constexpr std::string_view first_placeholder(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    std::size_t end = begin + 1;
    while (end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') || text[end] == '_')) ++end;
    if (text[begin] == '{' && end > begin + 1 && end < text.size() && text[end] == '}')
      return text.substr(begin, end + 1 - begin);
  }
  return {};
}

/// The placeholders of a finding in the order of its arguments. Each is there once.
struct Placeholders {
  static constexpr std::size_t most = 8;

  std::array<std::string_view, most> names{};
  std::size_t count = 0;

  /// Where `name` is; `count`: nowhere.
  constexpr std::size_t index_of(std::string_view name) const {
    std::size_t i = 0;
    while (i < count && names[i] != name) ++i;
    return i;
  }
};

constexpr Placeholders placeholders(const FindingRow& row) {
  Placeholders result;
  for (std::string_view rest : {row.text, row.hint}) {
    for (auto next = first_placeholder(rest); !next.empty(); next = first_placeholder(rest)) {
      if (result.index_of(next) == result.count) result.names[result.count++] = next;
      rest.remove_prefix(static_cast<std::size_t>(next.data() - rest.data()) + next.size());
    }
  }
  return result;
}

/// Is called when the arguments of a finding are not as many as its placeholders: then nothing is compiled.
void wrong_number_of_arguments();

/// A finding whose text and hint have `count` placeholders.
template <std::size_t count>
struct FindingWith {
  consteval FindingWith(Finding of) : finding(of) {  // NOLINT: a finding is meant wherever this is asked for
    if (placeholders(row(of)).count != count) wrong_number_of_arguments();
  }
  Finding finding;
};

/// One of two findings that have equally many placeholders.
template <Finding yes, Finding no>
constexpr auto either(bool condition) {
  using Result = FindingWith<placeholders(row(yes)).count>;
  return condition ? Result(yes) : Result(no);
}

inline std::string argument_text(std::string_view text) {
  return std::string(text);
}
inline std::string argument_text(std::integral auto number) {
  return std::to_string(number);
}

/// A finding with its arguments, before it is known where it stands.
struct PartialDiagnostic {
  template <class... Arguments>
  PartialDiagnostic(std::type_identity_t<FindingWith<sizeof...(Arguments)>> of, const Arguments&... given)
      : finding(of.finding), arguments{argument_text(given)...} {}

  Finding finding;
  std::vector<std::string> arguments;
};

/// The row's text and hint, with the arguments in the place of the placeholders.
std::string text_of(const PartialDiagnostic& what);
std::string hint_of(const PartialDiagnostic& what);

template <class... Arguments>
Diagnostic& Diagnostics::report(std::type_identity_t<FindingWith<sizeof...(Arguments)>> finding,
                                SourceSpan where, const Arguments&... arguments) {
  return report(PartialDiagnostic(finding, arguments...), where);
}

}  // namespace pal
