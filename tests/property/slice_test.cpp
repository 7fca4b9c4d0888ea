// A slice has all runs of the whole skill. So what all runs of a slice keep, no run of the skill breaks.
#include <catch2/catch.hpp>
#include <iostream>

#include "analyzer/exact/cap.hpp"
#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/slice/slice.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/silent_devices.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

struct SliceTally {
  std::size_t bounds = 0;  // of slices
  std::size_t proper = 0;  // of those that leave something out
  std::size_t equal = 0;   // the same as the exact one
};

bool is_timed(const Requirement& requirement) {
  return requirement.measure != Requirement::Measure::load &&
         requirement.measure != Requirement::Measure::busy;
}

/// `known`: exactly, with a run that shows it.
void expect_sound_slice(const Problem& problem, const Requirement& requirement, const Verdict& known,
                        Reach reach, Relaxation relaxation, ZoneGraph::Merging merging, SliceTally& tally) {
  const Cone cone = cone_of(problem, requirement, ProcessorId{}, reach);
  Limits limits;
  limits.classes = 3'000;
  const SliceBound found = bound_in(slice_of(problem, cone, relaxation), requirement,
                                    cap_of(problem, requirement.limit), limits, merging);
  if (!found.bound) return;
  INFO(requirement.name << (reach == Reach::least ? ", least" : "") << (relaxation.conditions ? ", free" : "")
                        << (relaxation.periods ? ", sporadic" : "") << ": slice " << *found.bound
                        << ", shown " << known.witness->measured.value << " " << known.witness->failed);
  REQUIRE_FALSE(known.witness->failed);
  if (requirement.at_least) {
    REQUIRE(*found.bound <= known.witness->measured.value);
  } else {
    REQUIRE(*found.bound >= known.witness->measured.value);
  }
  ++tally.bounds;
  tally.proper += cone.whole() ? 0 : 1;
  tally.equal += known.exact && *found.bound == known.witness->measured.value ? 1 : 0;
}

/// As the analysis uses them.
void expect_decision(const Problem& problem, const Requirement& requirement, const Verdict& known) {
  Options options;
  options.threads = 1;
  const SliceBound found = slice_bound(problem, requirement, options, 1'000);
  if (!found.bound) return;
  INFO(requirement.name << ": bound " << *found.bound << ", shown " << known.witness->measured.value);
  REQUIRE_FALSE(known.witness->failed);
  const Nanoseconds shown = known.witness->measured.value;
  CHECK((requirement.at_least ? *found.bound <= shown : *found.bound >= shown));
}

void expect_sound_slice_all(const Problem& problem, SliceTally& tally) {
  Options options;
  options.max_states = 2'000;
  options.threads = 1;
  const Analysis exact = analyze_exactly(problem, options);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& known = exact.verdicts[r];
    if (!is_timed(problem.requirements[r]) || !known.witness || known.witness->grows) continue;
    expect_decision(problem, problem.requirements[r], known);
    for (const Reach reach : {Reach::least, Reach::waits}) {
      for (const bool conditions : {false, true}) {
        const auto merging = conditions ? ZoneGraph::Merging::within : ZoneGraph::Merging::hull;
        for (const bool periods : {false, true})
          expect_sound_slice(problem, problem.requirements[r], known, reach, {conditions, periods}, merging,
                             tally);
      }
    }
  }
}

template <class Text>
void expect_sound_slice_seeds(const Text& text_of, std::uint64_t rounds, SliceTally& tally) {
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", rounds); ++seed) {
    const std::string text = text_of(seed);
    const auto skill = test::skill_from_text(text);
    if (!skill->problem || !fits_exploration(*skill->problem)) continue;
    INFO("seed " << seed << "\n" << text);
    expect_sound_slice_all(*skill->problem, tally);
  }
  std::cout << tally.bounds << " bounds of slices, " << tally.proper << " of proper ones; " << tally.equal
            << " equal to the exact bound\n";
}

}  // namespace

TEST_CASE("small skills: no run exceeds a bound of a slice") {
  SliceTally tally;
  expect_sound_slice_seeds(
      [](std::uint64_t seed) { return test::RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text(); }, 8, tally);
  CHECK(tally.proper > 0);
  CHECK(tally.equal > 0);
}

TEST_CASE("devices that may not answer: no run exceeds a bound of a slice") {
  SliceTally tally;
  expect_sound_slice_seeds(
      [](std::uint64_t seed) { return test::with_silent_devices(test::RandomSkill(seed, 9).text()); }, 10,
      tally);
  CHECK(tally.bounds > 0);
}

TEST_CASE("skills of all kinds: no run exceeds a bound of a slice") {
  SliceTally tally;
  expect_sound_slice_seeds(test::skill_of_any_kind, 12, tally);
  CHECK(tally.proper > 0);
  CHECK(tally.equal > 0);
}
