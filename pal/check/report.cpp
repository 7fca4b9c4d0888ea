#include "pal/check/report.hpp"

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/nearest.hpp"

namespace pal::check {

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

void report_twice(Diagnostics& diagnostics, const std::string& what, const syntax::Name& second,
                  const syntax::Name& first) {
  auto& finding =
      diagnostics.report(Code::PAL0205, second.where, what + " " + quoted(second.text) + " is declared twice",
                         "rename one of them, or remove it");
  finding.notes.push_back({first.where, "it is also declared here"});
}

bool may_guess(const Diagnostics& diagnostics, std::size_t known) {
  constexpr std::size_t most_guesses = 200;
  constexpr std::size_t most_comparisons = 200'000;
  const auto errors = diagnostics.errors();
  return errors < most_guesses && errors * known < most_comparisons;
}

void report_unknown(Diagnostics& diagnostics, Code code, const std::string& what, const syntax::Name& name,
                    const std::vector<std::string>& known, const std::string& otherwise,
                    const DeclaredAt& declared) {
  const auto meant = may_guess(diagnostics, known.size()) ? nearest(name.text, known) : std::nullopt;
  auto& finding = diagnostics.report(code, name.where, "there is no " + what + " " + quoted(name.text),
                                     meant ? "did you mean " + quoted(*meant) + "?" : otherwise);
  if (!meant) return;
  finding.fix = {{name.where, *meant}};
  const auto place = declared ? declared(*meant) : std::nullopt;
  if (place) finding.notes.push_back({*place, quoted(*meant) + " is declared here"});
}

}  // namespace pal::check
