#include "pal/support/diagnostic.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/finding.hpp"

namespace pal {

namespace {

struct Row {
  std::string_view name;
  Severity severity;
  std::string_view title;
};

constexpr std::array rows{
#define PAL_DIAGNOSTIC(code, severity, title) Row{#code, Severity::severity, title},
#include "pal/support/diagnostic_code.def"
};

/// The number of each row, and of the first one of each family.
enum RowNumber : int {
#define PAL_FAMILY(family) first_##family, before_##family = first_##family - 1,
#define PAL_DIAGNOSTIC(code, severity, title) row_##code,
#include "pal/support/diagnostic_code.def"
};

constexpr std::array first_rows{
#define PAL_FAMILY(family) static_cast<int>(first_##family),
#include "pal/support/diagnostic_code.def"
};

const Row& code_row(Code code) {
  return rows.at(static_cast<std::size_t>(code));
}

auto place(const SourceSpan& span) {
  return std::tuple(span.file.value, span.begin, span.end);
}

}  // namespace

std::string_view name(Code code) {
  return code_row(code).name;
}
Severity severity(Code code) {
  return code_row(code).severity;
}
Family family(Code code) {
  const auto after = std::upper_bound(first_rows.begin(), first_rows.end(), static_cast<int>(code));
  return static_cast<Family>(after - first_rows.begin() - 1);
}
std::string_view title(Code code) {
  return code_row(code).title;
}
std::size_t code_count() {
  return rows.size();
}

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

Diagnostic& Diagnostic::suggest(const std::optional<std::string>& near, const char* quote) {
  if (near) hint = "did you mean " + (quote + *near + quote) + "?";
  return *this;
}

Diagnostic& Diagnostic::say(const PartialDiagnostic& what) {
  message = text_of(what);
  hint = hint_of(what);
  finding = what.finding;
  arguments = what.arguments;
  return *this;
}

Diagnostic& Diagnostics::report(const PartialDiagnostic& what, SourceSpan where) {
  const Code code = row(what.finding).code;
  return keep({code, severity(code), where, {}, {}, {}, {}}).say(what);
}

Diagnostic& Diagnostics::report(const Diagnostic& found) {
  Diagnostic given = found;
  given.severity = severity(given.code);
  return keep(std::move(given));
}

Diagnostic& Diagnostics::keep(Diagnostic found) {
  const SourceSpan where = found.where;
  const auto level = found.severity;
  const auto follows = std::any_of(distrusted_.begin(), distrusted_.end(), [&](const SourceSpan& place) {
    return place.file == where.file && place.begin <= where.begin && where.begin < place.end;
  });
  if (!follows && level == Severity::error) ++errors_;
  const bool full = kept_.of(level) == most_kept;
  if (!follows) ++(full ? not_kept_ : kept_).of(level);
  if (follows || full) dropped_.clear();
  return (follows || full ? dropped_ : all_).emplace_back(std::move(found));
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  auto result = all_;
  const auto key = [](const Diagnostic& d) { return std::tuple(place(d.where), d.code); };
  std::stable_sort(result.begin(), result.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  const auto same = [&](const Diagnostic& a, const Diagnostic& b) {
    return key(a) == key(b) && a.message == b.message;
  };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

}  // namespace pal
