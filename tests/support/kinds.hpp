// Every kind of random skill that keeps within the execution model.
#pragma once

#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <string>

#include "tests/support/any_skill.hpp"
#include "tests/support/command_skill.hpp"
#include "tests/support/condition_chain.hpp"
#include "tests/support/ending_skill.hpp"
#include "tests/support/held_skill.hpp"
#include "tests/support/lone_skill.hpp"
#include "tests/support/many_parties.hpp"
#include "tests/support/nested_skill.hpp"
#include "tests/support/odd_skill.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/timed_skill.hpp"
#include "tests/support/woven_skill.hpp"

namespace pal::test {

using TextBySeed = std::function<std::string(std::uint64_t)>;

inline const std::map<std::string, TextBySeed>& kinds() {
  static const std::map<std::string, TextBySeed> all = {
      {"chance", [](std::uint64_t seed) { return RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text(); }},
      {"pace", [](std::uint64_t seed) { return TimedSkill(seed).text(); }},
      {"conditions", [](std::uint64_t seed) { return ConditionChain(seed).text(); }},
      {"held", [](std::uint64_t seed) { return HeldSkill(seed).text(); }},
      {"ending", [](std::uint64_t seed) { return EndingSkill(seed).text(); }},
      {"lone", [](std::uint64_t seed) { return LoneSkill(seed).text(); }},
      {"commands", [](std::uint64_t seed) { return CommandSkill(seed).text(); }},
      {"stopped", [](std::uint64_t seed) { return StoppedBlocks(seed).text(); }},
      {"woven", [](std::uint64_t seed) { return WovenSkill(seed, seed % 2 == 0).text(); }},
      {"nested", [](std::uint64_t seed) { return NestedSkill(seed).text(); }},
      {"parties", [](std::uint64_t seed) { return ManyParties(seed).text(); }},
      {"odd", [](std::uint64_t seed) { return OddSkill(seed, seed % 2 == 1).text(); }},
  };
  return all;
}

/// One of any kind.
inline std::string skill_of_any_kind(std::uint64_t seed) {
  const auto kind = std::next(kinds().begin(), static_cast<std::ptrdiff_t>(seed % kinds().size()));
  return kind->second(seed);
}

inline bool has_meaning(const std::string& text) {
  return any_skill(text)->problem.has_value();
}

}  // namespace pal::test
