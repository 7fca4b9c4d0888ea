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

TEST_CASE("a bound that no run goes beyond stays") {
  Verdict verdict = held(80, 80);
  CHECK_FALSE(is_refuted(verdict));
  verdict = withdrawn(verdict);
  CHECK(verdict.state == VerdictState::holds);
  CHECK(verdict.bound == Duration(80));
  verdict.witness.reset();
  CHECK_FALSE(is_refuted(verdict));
}

TEST_CASE("of a bound that a run goes beyond nothing is left") {
  Verdict verdict = held(80, 81);
  verdict = withdrawn(verdict);
  CHECK(verdict.state == VerdictState::undecided);
  CHECK_FALSE(verdict.bound);
  CHECK(verdict.addends.empty());
  CHECK(verdict.explanation.find("compositional analysis") != std::string::npos);
}

TEST_CASE("a requirement that such a run breaks fails") {
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

TEST_CASE("what never happens is refuted by a run in which it does") {
  Verdict verdict = held(0, 5);
  verdict.state = VerdictState::never;
  verdict.bound.reset();
  CHECK(is_refuted(verdict));
}

TEST_CASE("a load is refuted by what an unending run has") {
  Verdict verdict = held(500'000'000, 0);
  verdict.measure = Requirement::Measure::load;
  verdict.limit = Duration(1'000'000'000);
  verdict.attained_load = Duration(500'000'000);
  CHECK_FALSE(is_refuted(verdict));
  verdict.attained_load = Duration(500'000'001);
  CHECK(is_refuted(verdict));
}

TEST_CASE("an analysis that is wrong of one requirement is not believed of others") {
  std::vector<Verdict> verdicts{held(80, 70), held(80, 81), held(80, 70)};
  verdicts[2].method = Method::exact;
  withdraw_refuted(verdicts);
  CHECK(verdicts[0].state == VerdictState::undecided);
  CHECK_FALSE(verdicts[0].bound);
  CHECK(verdicts[2].state == VerdictState::holds);
}

TEST_CASE("an analysis that is wrong is not believed where the wrong bound is not used") {
  const std::vector<Verdict> proofs{held(80, 70), held(80, 81)};
  std::vector<Verdict> verdicts{held(80, 70), held(81, 81)};
  verdicts[1].method = Method::exact;
  withdraw_refuted(proofs, verdicts);
  CHECK(verdicts[0].state == VerdictState::undecided);
  CHECK(verdicts[1].state == VerdictState::holds);
}
