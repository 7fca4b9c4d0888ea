// What both analyses say of a skill, against what was reckoned by hand.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "analyzer/compositional/compositional.hpp"
#include "tests/support/skill.hpp"

namespace pal::test {

inline double milliseconds(const analyzer::Verdict& verdict) {
  return verdict.bound ? static_cast<double>(verdict.bound->count()) / 1e6 : -1;
}

/// Milliseconds, by requirement of the skill: its compositional bound and its exact one; -1: none.
inline void expect_bounds(const std::string& text, const std::vector<std::pair<double, double>>& expected) {
  const auto skill = test::sound_skill(text);
  const analyzer::Analysis compositional = analyzer::compositional::analyze(*skill->problem);
  const analyzer::Analysis exact = analyzer::analyze_exactly(*skill->problem);
  REQUIRE(compositional.verdicts.size() == expected.size());
  for (std::size_t r = 0; r < expected.size(); ++r) {
    INFO(compositional.verdicts[r].requirement << ": " << compositional.verdicts[r].explanation.text());
    CHECK(milliseconds(compositional.verdicts[r]) == expected[r].first);
    CHECK(milliseconds(exact.verdicts[r]) == expected[r].second);
  }
}

}  // namespace pal::test
