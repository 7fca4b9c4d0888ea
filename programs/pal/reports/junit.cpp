#include "programs/pal/reports/junit.hpp"

#include <fmt/format.h>

#include <sstream>

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/render.hpp"
#include "pal/support/xml.hpp"

namespace pal::program {
namespace {

struct Case {
  std::string name;
  std::string kind;     // "failure" or "error"; empty: it passes
  std::string message;  // in one line
  std::string text;
};

void write_suite(const std::string& name, const std::vector<Case>& cases, std::ostream& out) {
  const auto count = [&](std::string_view kind) {
    return std::count_if(cases.begin(), cases.end(), [&](const Case& each) { return each.kind == kind; });
  };
  out << fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                     xml_escaped(name), cases.size(), count("failure"), count("error"));
  for (const Case& each : cases) {
    out << fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml_escaped(name),
                       xml_escaped(each.name));
    if (each.kind.empty()) {
      out << "/>\n";
      continue;
    }
    out << fmt::format(">\n      <{} message=\"{}\">{}</{}>\n    </testcase>\n", each.kind,
                       xml_escaped(each.message), xml_escaped(each.text), each.kind);
  }
  out << "  </testsuite>\n";
}

/// What is found of requirements belongs to their own cases.
bool is_of_a_requirement(Code code) {
  return code == Code::PAL0890 || code == Code::PAL0891;
}

Case case_of(const std::string& file, FileId id, const Session& session) {
  Case result{file, {}, {}, {}};
  std::vector<Diagnostic> errors;
  for (const Diagnostic& finding : session.diagnostics.sorted()) {
    const bool here = finding.where.valid() ? finding.where.file == id : id.index() == 0;
    if (here && finding.severity == Severity::error && !is_of_a_requirement(finding.code))
      errors.push_back(finding);
  }
  if (errors.empty()) return result;
  std::ostringstream text;
  render_text(errors, session.sources, text);
  result.kind = "failure";
  result.message = std::string(name(errors.front().code)) + ": " + errors.front().message;
  result.text = text.str();
  return result;
}

Case case_of(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  Case result{verdict.requirement, {}, {}, {}};
  if (verdict.state == analyzer::VerdictState::holds) return result;
  const bool fails = verdict.state == analyzer::VerdictState::fails;
  result.kind = fails ? "failure" : "error";
  result.message = fmt::format("{} {}: at most {} is required, the bound is {}",
                               measure_text(proof.problem, index), analyzer::name(verdict.state),
                               whole_text(verdict.measure, verdict.limit), bound_text(verdict));
  result.text = result.message;
  return result;
}

}  // namespace

std::string junit(const std::vector<Proof>& proofs, const Session& session) {
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"pal check\">\n";
  std::vector<Case> files;
  for (std::size_t i = 0; i < session.sources.size(); ++i)
    files.push_back(case_of(session.sources.name(FileId(i)), FileId(i), session));
  write_suite("specification", files, out);
  for (const Proof& proof : proofs) {
    std::vector<Case> cases;
    for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i) cases.push_back(case_of(proof, i));
    write_suite(proof.problem.skill + " in " + proof.problem.environment, cases, out);
  }
  out << "</testsuites>\n";
  return out.str();
}

}  // namespace pal::program
