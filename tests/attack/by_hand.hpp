// A program worked out by hand, against the analyzer and against the runs that are made without it.
#pragma once

#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/runs/all_runs.hpp"

namespace pal::test {

/// A skill with a controller MC1 whose robot ticks, its modules and its environment.
inline std::string cell(const std::string& requirement, const std::string& modules,
                        const std::string& environment) {
  const auto has = [&modules](const std::string& header) {
    return modules.find(header) != std::string::npos;
  };
  return "MESSAGE motion : SIGNAL\nMESSAGE correction : SIGNAL\nMESSAGE tick : SIGNAL\nCONDITION c\nDEVICE "
         "robot\n"
         "SKILL odd\n  MACHINE CONTROLLER MC1" +
         std::string(has("Controller: MC2") ? ", MC2" : "") + "\n  SKILL METHOD SM1\n" +
         (has("Contingency Module: CM1") ? "  CONTINGENCY 1 \"no\" METHOD CM1\n" : "") +
         "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n  REQUIREMENT r : " + requirement +
         " AT MOST 1 s\nEND SKILL\n" + modules + "ENVIRONMENT cell\n" + environment + "END ENVIRONMENT\n";
}

/// Its bound in milliseconds, which must be exact, and what the runs attain that are made without the
/// analyzer; -1: it fails without one.
inline std::int64_t bound(const std::string& text) {
  const auto skill = any_skill(text);
  INFO(text << messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const analyzer::Analysis analysis = analyzer::analyze(*skill->problem);
  const analyzer::Verdict& verdict = analysis.verdicts.front();
  INFO(verdict.explanation);
  CHECK(verdict.exact);
  const pan::Network& network = skill->specification.skills.front();
  const pan::Environment& environment = skill->specification.environments.front();
  AllRuns runs(network, environment, wanted(network, environment).front(), Duration(1'000'000), 2000);
  const Seen seen = runs.enumerate(200'000);
  CHECK(seen.complete);
  if (verdict.bound) CHECK(Duration(seen.greatest * 1'000'000) == *verdict.bound);
  return verdict.bound ? verdict.bound->count() / 1'000'000 : -1;
}

}  // namespace pal::test
