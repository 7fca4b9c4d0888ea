// Both analyses against single runs of larger skills that are made without the analyzer
// (tests/support/runs/all_runs.hpp).
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "tests/differential/compare.hpp"
#include "tests/support/kept.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/refigured.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/small_skill.hpp"

using namespace pal;
using pal::test::has_meaning;
using pal::test::setting;

namespace {

/// Any of them with up to four mistakes in it.
std::string with_mistakes(std::uint64_t seed) {
  const std::size_t kinds = test::kinds().size();
  return test::Mutant(seed, test::skill_of_any_kind(seed), has_meaning)
      .text(1 + static_cast<int>(seed / kinds % 4));
}

/// One of those that the tests keep with up to four mistakes in it.
std::string kept_with_mistakes(std::uint64_t seed) {
  const std::vector<std::string>& all = test::kept_skills();
  return test::Mutant(seed, all[seed % all.size()], has_meaning)
      .text(static_cast<int>(seed / all.size() % 5));
}

/// One that is kept, or of any kind, mostly with a mistake or two, with other figures and asked everything.
std::string asked_everything(std::uint64_t seed) {
  const std::vector<std::string>& all = test::kept_skills();
  std::mt19937_64 engine(seed);
  const std::string text = seed % 3 == 0 ? test::skill_of_any_kind(seed / 3) : all[engine() % all.size()];
  const auto mistaken = test::Mutant(seed, text, has_meaning).text(static_cast<int>(engine() % 3));
  const std::string other = test::refigured(mistaken, engine);
  return test::asked_everything(has_meaning(other) ? other : mistaken, engine, setting("PAL_ASKED", 40));
}

/// So many skills of a kind.
void expect_all_sound(const std::string& kind, const test::TextBySeed& text, std::uint64_t rounds,
                      bool only_bounded = false) {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const test::Effort effort{setting("PAL_CLASSES", 500), setting("PAL_WALKS", only_bounded ? 8 : 20),
                            static_cast<int>(setting("PAL_THINGS", 800)), only_bounded};
  test::Compared all;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    all += test::compare(text(seed), seed, effort);
    INFO("seed " << seed << "\n" << all.contradiction);
    REQUIRE(all.contradiction.empty());
  }
  std::cout << kind << ": " << all.skills << " skills, " << all.requirements << " requirements, " << all.exact
            << " bounded exactly, " << all.bounded << " compositionally, " << all.measured << " measured\n";
  CHECK(all.measured > 0);
}

/// Of a part of the kinds, or of PAL_KIND alone.
void expect_sound_kinds(test::Part part) {
  const char* only = std::getenv("PAL_KIND");
  std::uint64_t number = 0;
  for (const auto& [kind, text] : test::kinds()) {
    const bool ours = number++ % part.of == part.number - 1;
    if (ours && (only == nullptr || kind == only)) expect_all_sound(kind, text, setting("PAL_ROUNDS", 3));
  }
}

}  // namespace

TEST_CASE("larger skills: no run exceeds a bound of either analysis, part 1 of 2") {
  expect_sound_kinds({1, 2});
}

TEST_CASE("larger skills: no run exceeds a bound of either analysis, part 2 of 2") {
  expect_sound_kinds({2, 2});
}

TEST_CASE("small skills in all orders: no run exceeds a bound of either analysis") {
  const auto small = [](std::uint64_t seed) { return test::SmallSkill(seed).text(); };
  expect_all_sound("small", small, setting("PAL_ROUNDS", 200), true);
}

TEST_CASE("methods with devices only: no run exceeds a bound of either analysis") {
  expect_all_sound("lone", test::kinds().at("lone"), setting("PAL_ROUNDS", 100), true);
}

TEST_CASE("larger skills with mistakes: no run exceeds a bound of either analysis") {
  expect_all_sound("mistakes", with_mistakes, setting("PAL_ROUNDS", 8));
}

TEST_CASE("kept skills with mistakes: no run exceeds a bound of either analysis") {
  expect_all_sound("kept", kept_with_mistakes, setting("PAL_ROUNDS", 30));
}

TEST_CASE("skills with other figures: no run exceeds a bound of either analysis") {
  expect_all_sound("asked everything", asked_everything, setting("PAL_ROUNDS", 20), true);
}
