#include "programs/pal/reports/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/support/render.hpp"
#include "pal/support/xml.hpp"

namespace pal::program {
namespace {

struct Case {
  std::string name;
  std::string kind;     // "failure", "error" or "skipped"; empty: it passes
  std::string type;     // the code of a finding
  std::string message;  // in one line
  std::string text;
  double seconds = 0;
};

struct Suite {
  std::string name;
  std::vector<Case> cases;

  std::size_t count(std::string_view kind) const {
    return static_cast<std::size_t>(
        std::count_if(cases.begin(), cases.end(), [&](const Case& each) { return each.kind == kind; }));
  }
  double seconds() const {
    double sum = 0;
    for (const Case& each : cases) sum += each.seconds;
    return sum;
  }
};

void write_case(const std::string& suite, const Case& each, std::ostream& out) {
  out << fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", xml_escaped(suite),
                     xml_escaped(each.name), each.seconds);
  if (each.kind.empty()) {
    out << (each.text.empty() ? "/>\n"
                              : fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n",
                                            xml_escaped(each.text)));
    return;
  }
  out << fmt::format(">\n      <{}", each.kind);
  if (!each.type.empty()) out << fmt::format(" type=\"{}\"", xml_escaped(each.type));
  out << fmt::format(" message=\"{}\">{}</{}>\n    </testcase>\n", xml_escaped(each.message),
                     xml_escaped(each.text), each.kind);
}

void write_suite(const Suite& suite, std::ostream& out) {
  out << fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n",
      xml_escaped(suite.name), suite.cases.size(), suite.count("failure"), suite.count("error"),
      suite.count("skipped"), suite.seconds());
  for (const Case& each : suite.cases) write_case(suite.name, each, out);
  out << "  </testsuite>\n";
}

/// Findings about requirements belong to the cases of these.
bool is_about_a_requirement(Code code) {
  return code == Code::PAL0890 || code == Code::PAL0891 || code == Code::PAL0816 || code == Code::PAL0892;
}

/// The findings as the text form has them: with place, parts, hint and fix.
void tell(const std::vector<Diagnostic>& findings, std::string kind, const Session& session, Case& result) {
  std::ostringstream text;
  render_text(findings, session.sources, text);
  const Diagnostic& first = findings.front();
  result.kind = std::move(kind);
  result.type = name(first.code);
  result.message = result.type + ": " + first.message;
  if (first.where.valid())
    result.message += fmt::format(" ({}:{})", session.sources.name(first.where.file),
                                  session.sources.line_column(first.where.file, first.where.begin).line);
  result.text = text.str();
}

/// The errors in one file; with `elsewhere`, also those that are in no file.
std::vector<Diagnostic> errors_in(FileId file, bool elsewhere, const Session& session) {
  std::vector<Diagnostic> errors;
  for (const Diagnostic& finding : session.diagnostics.sorted()) {
    const bool here = finding.where.valid() ? finding.where.file == file : elsewhere;
    if (here && finding.severity == Severity::error && !is_about_a_requirement(finding.code))
      errors.push_back(finding);
  }
  return errors;
}

Suite suite_of_files(const Session& session) {
  Suite suite{"specification", {}};
  for (std::size_t i = 0; i < session.sources.size(); ++i) {
    const FileId file(i);
    Case each{session.sources.name(file), {}, {}, {}, {}, 0};
    const auto errors = errors_in(file, i == 0, session);
    if (!errors.empty()) tell(errors, is_unread(file, session) ? "error" : "failure", session, each);
    suite.cases.push_back(std::move(each));
  }
  return suite;
}

Case case_of(const Proof& proof, std::size_t index, const Session& session) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  Case result{verdict.requirement, {}, {}, {}, {}, verdict.statistics.seconds};
  if (verdict.state == analyzer::VerdictState::holds) {
    if (const auto lost = taken_as_lost(proof, index)) result.text = text_of(*lost);
    if (proof.half_open) result.text += std::string(result.text.empty() ? "" : "\n") + half_open_text;
    return result;
  }
  Diagnostics own;
  report_unmet(proof, index, true, own);
  tell(own.all(), verdict.state == analyzer::VerdictState::fails ? "failure" : "error", session, result);
  return result;
}

std::string suite_name(const std::string& skill, const std::string& environment) {
  return environment.empty() ? skill : skill + " in " + environment;
}

/// Requirements without a verdict have suites of their own.
std::vector<Suite> suites_of(const std::vector<Unchecked>& not_checked, bool required) {
  std::vector<Suite> suites;
  for (const Unchecked& row : not_checked) {
    const std::string name = row.skill.empty() ? "pal check" : suite_name(row.skill, row.environment);
    if (suites.empty() || suites.back().name != name) suites.push_back({name, {}});
    const std::string hint = row.hint.empty() ? "" : "hint: " + row.hint + "\n";
    const bool fault = required && !row.left_out;
    suites.back().cases.push_back(
        {row.requirement.empty() ? "has a requirement" : row.requirement, fault ? "error" : "skipped",
         fault ? "PAL0892" : "", (row.skill.empty() ? "nothing was checked: " : "not checked: ") + row.reason,
         hint, 0});
  }
  return suites;
}

}  // namespace

std::string junit(const std::vector<Proof>& proofs, const std::vector<Unchecked>& not_checked, bool required,
                  const Session& session) {
  std::vector<Suite> suites{suite_of_files(session)};
  for (const Proof& proof : proofs) {
    if (proof.analysis.verdicts.empty()) continue;  // told by `not_checked`
    suites.push_back({heading_of(proof), {}});
    for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i)
      suites.back().cases.push_back(case_of(proof, i, session));
  }
  for (Suite& suite : suites_of(not_checked, required)) suites.push_back(std::move(suite));
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"pal check\">\n";
  for (const Suite& suite : suites) write_suite(suite, out);
  out << "</testsuites>\n";
  return out.str();
}

}  // namespace pal::program
