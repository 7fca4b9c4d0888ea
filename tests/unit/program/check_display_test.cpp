// What a terminal shows while a check is at work.
#include "programs/pal/reports/check_display.hpp"

#include "programs/pal/session/proof.hpp"
#include "tests/unit/program/program.hpp"

namespace pal::test {
namespace {

program::Proof proof_of_touch() {
  program::Session session;
  std::ostringstream out, err;
  const DiskFileSystem files;
  program::Selection selection;
  selection.files = {touch};
  selection.environments = {cell};
  REQUIRE(program::read(selection, {out, err, files}, session));
  program::ProofLimits limits;
  limits.analysis = analyzer::AnalysisChoice::compositional;
  return std::move(program::prove(session, limits).front());
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

}  // namespace

TEST_CASE("a check at work shows what is known, and takes it back") {
  const program::Proof proof = proof_of_touch();
  std::ostringstream out;
  {
    program::CheckDisplay display(out, {24, 200}, std::chrono::milliseconds(0));
    analyzer::Analysis known = analyzer::nothing_known(proof.problem, "");
    display.show(proof.problem, known);
    CHECK(occurrences(out.str(), "  open ") == known.verdicts.size());
    CHECK(out.str().find("] 0 of ") != std::string::npos);
    const std::string before = out.str();
    display.show(proof.problem, known);
    CHECK(out.str() == before);  // nothing new
    display.show(proof.problem, proof.analysis);
    CHECK(out.str().find("  holds ") != std::string::npos);
  }
  const std::string up = "\x1b[" + std::to_string(proof.analysis.verdicts.size() + 2) + "A\r\x1b[J";
  CHECK(occurrences(out.str(), up) == 2);  // once for each that was shown
  CHECK(out.str().ends_with(up));
}

TEST_CASE("what a check shows fits the terminal") {
  const program::Proof proof = proof_of_touch();
  REQUIRE(proof.analysis.verdicts.size() > 1);
  std::ostringstream out;
  program::CheckDisplay display(out, {5, 40}, std::chrono::milliseconds(0));
  display.show(proof.problem, proof.analysis);
  std::istringstream lines(out.str());
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line); ++number) CHECK(line.size() <= 41);  // … is three bytes
  CHECK(number == 4);
}

TEST_CASE("a proof that is over soon is not shown") {
  const program::Proof proof = proof_of_touch();
  std::ostringstream out;
  {
    program::CheckDisplay display(out, {24, 80}, std::chrono::hours(1));
    display.show(proof.problem, proof.analysis);
  }
  CHECK(out.str().empty());
}

}  // namespace pal::test
