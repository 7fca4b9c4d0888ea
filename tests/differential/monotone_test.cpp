// A skill that allows every run of another measures at least as much, and one told in another way measures
// the same.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "analyzer/verdict/refuted.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/retold.hpp"
#include "tests/support/rewritten.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/wider.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

Analysis exactly(const Problem& problem) {
  Options options;
  options.max_states = setting("PAL_CLASSES", 1'500);
  options.threads = 1;
  return analyze_exactly(problem, options);
}

std::string claim(const Verdict& verdict) {
  std::ostringstream out;
  out << name(verdict.method) << " " << name(verdict.state);
  if (verdict.bound) out << " " << verdict.bound->count();
  if (verdict.exact) out << " exact";
  out << ", " << verdict.explanation.text() << "\n";
  return out.str();
}

/// Whether something that `narrow` proved of some run contradicts what `wide` says of all.
bool contradicts(const Verdict& narrow, Verdict wide) {
  wide.witness = narrow.witness;
  wide.attained_load = narrow.attained_load;
  if (is_refuted(wide)) return true;
  if (narrow.state == VerdictState::fails)
    return wide.state == VerdictState::holds || wide.state == VerdictState::never ||
           (narrow.exact && !narrow.bound && wide.bound);
  if (narrow.exact && narrow.bound && !narrow.at_least && wide.bound) return *narrow.bound > *wide.bound;
  return false;
}

struct MonotoneTally {
  std::size_t pairs = 0;
  std::size_t compared = 0;
  std::size_t exact = 0;
  std::size_t changed = 0;
  std::size_t limits = 0;
  std::size_t undecided = 0;
};

/// What is known of all runs of `wide` against what is known of some of `narrow`, by requirement.
std::string contradiction(const Analysis& narrow, const Analysis& wide, MonotoneTally& tally) {
  std::map<std::string, const Verdict*> by_name;
  for (const Verdict& verdict : narrow.verdicts) by_name[verdict.requirement] = &verdict;
  for (const Verdict& verdict : wide.verdicts) {
    const auto found = by_name.find(verdict.requirement);
    if (found == by_name.end()) continue;
    ++tally.compared;
    tally.exact += found->second->exact && verdict.exact ? 1 : 0;
    tally.changed += found->second->exact && verdict.exact && found->second->bound != verdict.bound ? 1 : 0;
    if (contradicts(*found->second, verdict))
      return verdict.requirement + "\nfewer runs: " + claim(*found->second) + "more runs: " + claim(verdict);
  }
  return {};
}

/// With limits that are just met, or just not. The bounds stay what they are.
std::string contradiction_of_limits(Problem problem, const Analysis& before, std::uint64_t seed,
                                    MonotoneTally& tally) {
  std::vector<bool> met(problem.requirements.size());
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& known = before.verdicts[r];
    if (!known.exact || !known.bound) continue;
    met[r] = (seed + r) % 2 == 0 || (!known.at_least && known.bound->count() == 0);
    problem.requirements[r].limit = known.bound->count() + (met[r] ? 0 : known.at_least ? 1 : -1);
  }
  const Analysis after = exactly(problem);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& known = before.verdicts[r];
    const Verdict& verdict = after.verdicts[r];
    if (!known.exact || !known.bound || known.state == VerdictState::never) continue;
    ++tally.limits;
    tally.undecided += verdict.state == VerdictState::undecided ? 1 : 0;
    const bool other = verdict.exact && verdict.bound && verdict.bound != known.bound;
    const VerdictState wrong = met[r] ? VerdictState::fails : VerdictState::holds;
    if (other || verdict.state == wrong || verdict.state == VerdictState::never)
      return known.requirement + "\nwas: " + claim(known) + "with another limit: " + claim(verdict);
  }
  return {};
}

/// Draws what is wider than another, or the same.
class Pairs {
 public:
  Pairs(const std::string& text, std::uint64_t seed) : text_(text), engine_(seed) {}

  /// What is wrong; "": nothing.
  std::string wrong(MonotoneTally& tally) {
    const auto skill = test::any_skill(text_);
    if (!skill->problem) return {};
    if (engine_() % 3 == 0) return written_otherwise(*skill->problem, tally);
    pan::Network network = skill->specification.skills.front();
    pan::Environment environment = skill->specification.environments.front();
    std::string how;
    if (engine_() % 3 != 0) how = "with " + test::other_times(network, environment, engine_);
    const std::optional<Problem> base = problem(network, environment);
    if (!base) return {};
    const Analysis before = exactly(*base);
    if (std::string found = contradiction_of_limits(*base, before, engine_(), tally); !found.empty())
      return how + found;
    if (std::string found = told_otherwise(*base, before, tally); !found.empty()) return how + found;
    const std::string wider = test::widen(network, environment, engine_);
    const std::optional<Problem> wide = problem(network, environment);
    if (!wide || wider.empty()) return {};
    ++tally.pairs;
    std::string found = contradiction(before, exactly(*wide), tally);
    if (found.empty()) found = contradiction(before, compositional::analyze(*wide), tally);
    return found.empty() ? found : how + " wider: " + wider + "\n" + found;
  }

 private:
  static std::optional<Problem> problem(const pan::Network& network, const pan::Environment& environment) {
    Diagnostics diagnostics;
    return make_problem(network, environment, diagnostics);
  }

  std::string written_otherwise(const Problem& base, MonotoneTally& tally) {
    const std::string text = test::rewritten(text_, engine_);
    const auto skill = test::any_skill(text);
    if (!skill->problem) {
      if (std::getenv("PAL_REFUSED") != nullptr) std::cout << test::messages(skill->diagnostics) << text;
      return {};
    }
    ++tally.pairs;
    const Analysis before = exactly(base);
    const Analysis after = exactly(*skill->problem);
    std::string found = contradiction(before, after, tally);
    if (found.empty()) found = contradiction(after, before, tally);
    if (found.empty()) found = contradiction(before, compositional::analyze(*skill->problem), tally);
    return found.empty() ? found : " written so:\n" + text + "\n" + found;
  }

  std::string told_otherwise(const Problem& base, const Analysis& before, MonotoneTally& tally) {
    Problem same = base;
    const std::string told = test::retell(same, engine_);
    const Analysis after = exactly(same);
    ++tally.pairs;
    std::string found = contradiction(before, after, tally);
    if (found.empty()) found = contradiction(after, before, tally);
    // Steps that nothing reaches are none of the compositional analysis.
    if (found.empty() && told.find("twins") == std::string::npos)
      found = contradiction(before, compositional::analyze(same), tally);
    return found.empty() ? found : " told with " + told + "\n" + found;
  }

  const std::string& text_;
  std::mt19937_64 engine_;
};

std::string text_of(std::uint64_t seed) {
  std::string text =
      seed % 3 != 0
          ? test::RandomCell(seed, 3, static_cast<int>(seed / 3 % 3), test::RandomCell::Asks::all).text()
          : test::skill_of_any_kind(seed / 3);
  if (seed % 4 < 2) return text;
  return test::Mutant(seed, text, test::has_meaning).text(1 + static_cast<int>(seed % 5));
}

void expect_monotone(test::Part part) {
  MonotoneTally tally;
  for (const std::uint64_t seed : test::seeds(1, 12, part)) {
    const std::string text = text_of(seed);
    const std::string wrong = Pairs(text, seed).wrong(tally);
    if (!wrong.empty()) std::cout << "seed " << seed << ": " << wrong << std::endl;
    INFO("seed " << seed << "\n" << text);
    CHECK(wrong == "");
  }
  std::cout << tally.pairs << " pairs, " << tally.compared << " verdicts compared, " << tally.exact
            << " exact ones, of which " << tally.changed << " have changed; " << tally.limits
            << " other limits, of which " << tally.undecided << " undecided\n";
  CHECK(tally.exact > 0);
}

}  // namespace

TEST_CASE("more runs measure no less, and another text measures the same, part 1 of 3") {
  expect_monotone({1, 3});
}

TEST_CASE("more runs measure no less, and another text measures the same, part 2 of 3") {
  expect_monotone({2, 3});
}

TEST_CASE("more runs measure no less, and another text measures the same, part 3 of 3") {
  expect_monotone({3, 3});
}
