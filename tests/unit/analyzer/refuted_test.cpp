// A run counts more than a proof.
#include <catch2/catch.hpp>

#include "analyzer/verdict/refuted.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

Verdict held(Nanoseconds bound, Nanoseconds seen) {
  Verdict verdict;
  verdict.method = Method::compositional;
  verdict.measure = Requirement::Measure::response;
  verdict.state = VerdictState::holds;
  verdict.limit = Duration(100);
  verdict.bound = Duration(bound);
  verdict.addends = {{bound, "", "", "", 0, {}}};
  verdict.witness.emplace();
  verdict.witness->measured.value = seen;
  return verdict;
}

Verdict withdrawn(const Verdict& verdict) {
  std::vector<Verdict> one{verdict};
  withdraw_refuted(one);
  return one.front();
}

}  // namespace

TEST_CASE("a bound that no run exceeds stays") {
  Verdict verdict = held(80, 80);
  CHECK_FALSE(is_refuted(verdict));
  verdict = withdrawn(verdict);
  CHECK(verdict.state == VerdictState::holds);
  CHECK(verdict.bound == Duration(80));
  verdict.witness.reset();
  CHECK_FALSE(is_refuted(verdict));
}

TEST_CASE("a bound that a run exceeds is withdrawn") {
  Verdict verdict = held(80, 81);
  verdict = withdrawn(verdict);
  CHECK(verdict.state == VerdictState::undecided);
  CHECK_FALSE(verdict.bound);
  CHECK(verdict.addends.empty());
  CHECK(verdict.explanation.text().find("compositional analysis") != std::string::npos);
}

TEST_CASE("a requirement fails if the run that refutes its bound breaks it") {
  CHECK(withdrawn(held(80, 101)).state == VerdictState::fails);
  Verdict unanswered = held(80, 0);
  unanswered.witness->failed = true;
  unanswered = withdrawn(unanswered);
  CHECK(unanswered.state == VerdictState::fails);
  CHECK_FALSE(unanswered.bound);
}

TEST_CASE("a least value is refuted from below") {
  Verdict verdict = held(120, 119);
  verdict.at_least = true;
  CHECK(is_refuted(verdict));
  verdict = withdrawn(verdict);
  CHECK(verdict.state == VerdictState::undecided);
  CHECK_FALSE(is_refuted(verdict));
}

TEST_CASE("the verdict 'never' is refuted by a run that measures a value") {
  Verdict verdict = held(0, 5);
  verdict.state = VerdictState::never;
  verdict.bound.reset();
  CHECK(is_refuted(verdict));
}

TEST_CASE("a load is refuted by the greater load of an unending run") {
  Verdict verdict = held(500'000'000, 0);
  verdict.measure = Requirement::Measure::load;
  verdict.limit = Duration(1'000'000'000);
  verdict.attained_load = Duration(500'000'000);
  CHECK_FALSE(is_refuted(verdict));
  verdict.attained_load = Duration(500'000'001);
  CHECK(is_refuted(verdict));
}

TEST_CASE("an analysis that is wrong for one requirement is not used for others") {
  std::vector<Verdict> verdicts{held(80, 70), held(80, 81), held(80, 70)};
  verdicts[2].method = Method::exact;
  withdraw_refuted(verdicts);
  CHECK(verdicts[0].state == VerdictState::undecided);
  CHECK_FALSE(verdicts[0].bound);
  CHECK(verdicts[2].state == VerdictState::holds);
}

TEST_CASE("a wrong analysis is not used for others even if an exact bound replaced its wrong one") {
  const std::vector<Verdict> proofs{held(80, 70), held(80, 81)};
  std::vector<Verdict> verdicts{held(80, 70), held(81, 81)};
  verdicts[1].method = Method::exact;
  withdraw_refuted(proofs, verdicts);
  CHECK(verdicts[0].state == VerdictState::undecided);
  CHECK(verdicts[1].state == VerdictState::holds);
}
