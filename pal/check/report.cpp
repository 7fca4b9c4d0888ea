#include "pal/check/report.hpp"

#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::check {

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

void report_twice(Diagnostics& diagnostics, const std::string& what, const syntax::Name& second,
                  const syntax::Name& first) {
  auto& finding = diagnostics.report(Finding::declared_twice, second.where, what, second.text);
  finding.note(first.where, Remark::also_declared);
}

bool may_guess(const Diagnostics& diagnostics, std::size_t known) {
  constexpr std::size_t most_guesses = 200;
  constexpr std::size_t most_comparisons = 200'000;
  const auto errors = diagnostics.errors();
  return errors < most_guesses && errors * known < most_comparisons;
}

void report_unknown(Diagnostics& diagnostics, const PartialDiagnostic& what, const syntax::Name& name,
                    const std::vector<std::string>& known, const DeclaredAt& declared) {
  const auto meant = may_guess(diagnostics, known.size()) ? nearest(name.text, known) : std::nullopt;
  auto& finding = diagnostics.report(what, name.where).suggest(meant);
  if (!meant) return;
  finding.fix = {{name.where, *meant}};
  const auto place = declared ? declared(*meant) : std::nullopt;
  if (place) finding.note(*place, Remark::name_declared, *meant);
}

}  // namespace pal::check
