// What simulation shows, what exact analysis proves and what compositional analysis proves, of one program.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "analyzer/problem/problem.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/skill.hpp"

namespace pal::test {

/// What was compared, by measure.
struct Tally {
  struct Of {
    std::size_t requirements = 0;
    std::size_t bounds = 0;     // compositional ones
    std::size_t simulated = 0;  // bounds that some run has a value for
    std::size_t exact = 0;      // bounds compared with exact ones
    std::size_t equal = 0;
  };
  std::size_t programs = 0;
  std::map<std::string, Of> of;
};

/// Requires of each requirement of the problem that no run is beyond what is proved, and no exact bound
/// beyond a compositional one. The exact analysis has PAL_STATES classes at the most, or `states`; with none
/// it is not asked.
void expect_sandwich(const analyzer::Problem& problem, std::uint64_t seed, std::size_t states, Tally& tally);

/// Prints it; something must have been compared.
void say(const Tally& tally);

/// Compares PAL_ROUNDS programs, or `rounds`, from PAL_SEED on, or 1, or a part of them. `skill_of` makes a
/// skill of the text that `text_of` has for a seed; without a problem it is passed over.
Tally compare_by_chance(std::uint64_t rounds, std::size_t states,
                        const std::function<std::string(std::uint64_t)>& text_of,
                        const std::function<std::unique_ptr<Skill>(const std::string&)>& skill_of,
                        Part part = {});

/// Whether so many rounds from the first seed on are what is made, so that it is known how much they compare.
bool usual(std::uint64_t rounds);

}  // namespace pal::test
