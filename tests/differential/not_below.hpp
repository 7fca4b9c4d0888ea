// A bound of the compositional analysis against the exact one.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "tests/support/any_skill.hpp"

namespace pal::test {

/// The exact bound of the first requirement of a skill. The compositional analysis must have none below it.
inline std::int64_t exact_and_not_below(const std::string& text) {
  const auto skill = meaningful_skill(text);
  const analyzer::Verdict exact = analyzer::analyze_exactly(*skill->problem).verdicts.front();
  REQUIRE(exact.exact);
  REQUIRE(exact.bound);
  const analyzer::Verdict bound = analyzer::compositional::analyze(*skill->problem).verdicts.front();
  if (bound.bound) CHECK(*bound.bound >= *exact.bound);
  return exact.bound->count();
}

}  // namespace pal::test
