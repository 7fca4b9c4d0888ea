// The findings by name, each with its text and hint, from the one table in diagnostic_code.def. Whoever
// reports one names it and gives the arguments of its placeholders; their number is checked when it is
// compiled. The notes of findings likewise, from notes.def.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/placeholders.hpp"

namespace pal {

enum class Finding : std::uint16_t {
#define PAL_FINDING(code, name, text, hint) name,
#include "pal/support/diagnostic_code.def"
};

/// Whom a hint helps: whoever reads it, or only whoever writes the file as text.
enum class HintFor { all, writers };
/// "all", "writers".
std::string_view name(HintFor whom);

/// A row of the table.
struct FindingRow {
  std::string_view name;
  Code code;
  std::string_view text;
  std::string_view hint;  // empty: there is none
  HintFor hint_for = HintFor::all;
};

/// All rows; a finding is its row's number.
inline constexpr std::array finding_rows{
#define PAL_FINDING(code, name, text, hint) FindingRow{#name, Code::code, text, hint},
#define PAL_FINDING_IN_FILE(code, name, text, hint) \
  FindingRow{#name, Code::code, text, hint, HintFor::writers},
#include "pal/support/diagnostic_code.def"
};

constexpr const FindingRow& row(Finding finding) {
  return finding_rows[static_cast<std::size_t>(finding)];
}

constexpr Placeholders placeholders(const FindingRow& row) {
  return placeholders_in({row.text, row.hint});
}
constexpr Placeholders placeholders(Finding finding) {
  return placeholders(row(finding));
}

/// The texts at a second place of a finding.
enum class Remark : std::uint16_t {
#define PAL_NOTE(name, text) name,
#include "pal/support/findings/notes.def"
#undef PAL_NOTE
};

/// By remark.
inline constexpr std::array<std::string_view, 0
#define PAL_NOTE(name, text) +1
#include "pal/support/findings/notes.def"
#undef PAL_NOTE
                            >
    remark_texts{
#define PAL_NOTE(name, text) text,
#include "pal/support/findings/notes.def"
#undef PAL_NOTE
    };

constexpr std::string_view text(Remark remark) {
  return remark_texts[static_cast<std::size_t>(remark)];
}
constexpr Placeholders placeholders(Remark remark) {
  return placeholders_in({text(remark)});
}

/// One of two findings that have equally many placeholders.
template <Finding yes, Finding no>
constexpr auto either(bool condition) {
  using Result = FindingWith<placeholders(yes).count>;
  return condition ? Result(yes) : Result(no);
}

/// Of the first step of a run that is told: whether the run begins with it.
constexpr RemarkWith<2> beginning_of_run(bool whole) {
  return whole ? RemarkWith<2>(Remark::first_of_run) : RemarkWith<2>(Remark::end_of_run);
}

/// A finding with its arguments, before it is known where it stands.
struct PartialDiagnostic {
  template <class... Arguments>
  PartialDiagnostic(std::type_identity_t<FindingWith<sizeof...(Arguments)>> of, const Arguments&... given)
      : finding(of.row), arguments{argument_text(given)...} {}

  Finding finding;
  std::vector<std::string> arguments;
};

/// The row's text and hint, with the arguments in the place of the placeholders.
std::string text_of(const PartialDiagnostic& what);
std::string hint_of(const PartialDiagnostic& what);

/// The arguments of a finding, each with the name of its placeholder.
std::vector<std::pair<std::string_view, std::string_view>> named_arguments(const Diagnostic& finding);

template <class... Arguments>
Diagnostic& Diagnostics::report(std::type_identity_t<FindingWith<sizeof...(Arguments)>> finding,
                                SourceSpan where, const Arguments&... arguments) {
  return report(PartialDiagnostic(finding, arguments...), where);
}

template <class... Arguments>
Note::Note(SourceSpan at, std::type_identity_t<RemarkWith<sizeof...(Arguments)>> remark,
           const Arguments&... arguments)
    : where(at),
      text(filled(pal::text(remark.row), placeholders(remark.row), {argument_text(arguments)...})) {}

template <class... Arguments>
Diagnostic& Diagnostic::note(SourceSpan at, std::type_identity_t<RemarkWith<sizeof...(Arguments)>> remark,
                             const Arguments&... given) {
  notes.emplace_back(at, remark, given...);
  return *this;
}

}  // namespace pal
