// Both analyses against single runs of larger skills that are made without the analyzer
// (tests/support/runs/all_runs.hpp).
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <numeric>
#include <regex>
#include <string>
#include <vector>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "tests/attack/contradiction.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/command_skill.hpp"
#include "tests/support/condition_chain.hpp"
#include "tests/support/held_skill.hpp"
#include "tests/support/many_parties.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/nested_skill.hpp"
#include "tests/support/odd_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/timed_skill.hpp"
#include "tests/support/woven_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

/// What all times of a text are multiples of.
Duration grain(const std::string& text) {
  static const std::regex time(R"(([0-9]+)(?:\.([0-9]+))?(?: TO [0-9.]+)? ?(ns|us|ms|s|min)\b)");
  static const std::map<std::string, std::int64_t> units = {
      {"ns", 1}, {"us", 1'000}, {"ms", 1'000'000}, {"s", 1'000'000'000}, {"min", 60'000'000'000}};
  std::int64_t common = 0;
  const auto take = [&](const std::string& whole, const std::string& digits, std::int64_t unit) {
    std::int64_t least = unit;
    for (std::size_t i = 0; i < digits.size(); ++i) least /= 10;
    common = std::gcd(common, std::stoll(whole) * unit + (digits.empty() ? 0 : std::stoll(digits) * least));
  };
  for (std::sregex_iterator at(text.begin(), text.end(), time), end; at != end; ++at)
    take((*at)[1], (*at)[2], units.at((*at)[3]));
  static const std::regex last(R"( TO ([0-9]+)(?:\.([0-9]+))? ?(ns|us|ms|s|min)\b)");
  for (std::sregex_iterator at(text.begin(), text.end(), last), end; at != end; ++at)
    take((*at)[1], (*at)[2], units.at((*at)[3]));
  return Duration(std::max<std::int64_t>(common, 1));
}

constexpr Duration longest = std::chrono::seconds(1);

using Text = std::function<std::string(std::uint64_t)>;

const std::map<std::string, Text>& kinds() {
  static const std::map<std::string, Text> all = {
      {"chance", [](std::uint64_t seed) { return test::RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text(); }},
      {"pace", [](std::uint64_t seed) { return test::TimedSkill(seed).text(); }},
      {"conditions", [](std::uint64_t seed) { return test::ConditionChain(seed).text(); }},
      {"held", [](std::uint64_t seed) { return test::HeldSkill(seed).text(); }},
      {"commands", [](std::uint64_t seed) { return test::CommandSkill(seed).text(); }},
      {"stopped", [](std::uint64_t seed) { return test::StoppedBlocks(seed).text(); }},
      {"woven", [](std::uint64_t seed) { return test::WovenSkill(seed, seed % 2 == 0).text(); }},
      {"nested", [](std::uint64_t seed) { return test::NestedSkill(seed).text(); }},
      {"parties", [](std::uint64_t seed) { return test::ManyParties(seed).text(); }},
      {"odd", [](std::uint64_t seed) { return test::OddSkill(seed, seed % 2 == 1).text(); }},
  };
  return all;
}

bool has_meaning(const std::string& text) {
  return test::any_skill(text)->problem.has_value();
}

/// Any of them with up to four mistakes in it.
std::string with_mistakes(std::uint64_t seed) {
  const std::string right =
      std::next(kinds().begin(), static_cast<std::ptrdiff_t>(seed % kinds().size()))->second(seed);
  return test::Mutant(seed, right, has_meaning).text(1 + static_cast<int>(seed / kinds().size() % 4));
}

/// Those that the tests keep, mostly because they broke something once.
std::vector<std::string> kept() {
  std::vector<std::string> texts;
  const std::filesystem::path root = PAL_SOURCE_DIR;
  for (const char* folder : {"attack", "figures", "golden/check", "property/sandwich"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "tests" / folder)) {
      if (entry.path().extension() != ".pal") continue;
      const std::string text = test::project_file(std::filesystem::relative(entry.path(), root).string());
      if (has_meaning(text)) texts.push_back(text);
    }
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

/// One of them with up to four mistakes in it.
std::string kept_with_mistakes(std::uint64_t seed) {
  static const std::vector<std::string> all = kept();
  return test::Mutant(seed, all[seed % all.size()], has_meaning)
      .text(static_cast<int>(seed / all.size() % 5));
}

struct Tally {
  std::size_t skills = 0;
  std::size_t requirements = 0;
  std::size_t exact = 0;     // bounds of the exact analysis
  std::size_t bounded = 0;   // of the compositional one
  std::size_t measured = 0;  // requirements of which some run has a value
};

const Verdict* of(const Analysis& analysis, const std::string& requirement) {
  for (const Verdict& each : analysis.verdicts) {
    if (each.requirement == requirement) return &each;
  }
  return nullptr;
}

void attack(const std::string& text, std::uint64_t seed, Tally& tally) {
  const auto skill = test::any_skill(text);
  if (!skill->problem) return;
  ++tally.skills;
  const pan::Network& network = skill->specification.skills.front();
  const pan::Environment& environment = skill->specification.environments.front();
  const Duration unit = grain(text);
  const int cap = static_cast<int>(longest / unit);
  Options options;
  options.max_states = setting("PAL_CLASSES", 500);
  const Analysis exact = analyze(*skill->problem, options);
  const Analysis compositional = analyze_compositionally(*skill->problem);
  for (const test::Wanted& wanted : test::wanted(network, environment)) {
    if (wanted.kind == test::Wanted::Kind::load) continue;
    const Verdict* verdicts[] = {of(exact, wanted.name), of(compositional, wanted.name)};
    REQUIRE((verdicts[0] != nullptr && verdicts[1] != nullptr));
    ++tally.requirements;
    tally.exact += verdicts[0]->bound ? 1 : 0;
    tally.bounded += verdicts[1]->bound ? 1 : 0;
    test::AllRuns runs(network, environment, wanted, unit, cap);
    bool measured = false;
    for (std::uint64_t walk = 0; walk < setting("PAL_WALKS", 20); ++walk) {
      const auto seen = [&] {
        test::Gambler gambler(seed * 1000 + walk);
        return runs.walk(gambler, static_cast<int>(setting("PAL_THINGS", 800)));
      };
      const test::Seen one = seen();
      measured = measured || one.greatest >= 0 || one.least >= 0;
      for (const Verdict* verdict : verdicts) {
        const std::string wrong = test::contradiction(wanted, one, *verdict, unit, cap);
        if (wrong.empty()) continue;
        runs.tell = true;
        seen();
        std::string story;
        for (const std::string& line : runs.story) story += line + "\n";
        FAIL("seed " << seed << " walk " << walk << " " << wanted.name << ": " << name(verdict->state) << " "
                     << (verdict->bound ? verdict->bound->count() : -1) << " "
                     << (verdict == verdicts[0] ? "exact, " : "compositional, ") << verdict->explanation
                     << "\n"
                     << wrong << "\n"
                     << text << story);
      }
    }
    tally.measured += measured ? 1 : 0;
  }
}

/// So many skills of a kind.
void attack_all(const std::string& kind, const Text& text, std::uint64_t rounds) {
  const std::uint64_t first = setting("PAL_SEED", 1);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) attack(text(seed), seed, tally);
  std::cout << kind << ": " << tally.skills << " skills, " << tally.requirements << " requirements, "
            << tally.exact << " bounded exactly, " << tally.bounded << " compositionally, " << tally.measured
            << " measured\n";
  CHECK(tally.measured > 0);
}

}  // namespace

TEST_CASE("no run of a larger skill exceeds what either analysis proved") {
  const char* only = std::getenv("PAL_KIND");
  for (const auto& [kind, text] : kinds()) {
    if (only == nullptr || kind == only) attack_all(kind, text, setting("PAL_ROUNDS", 5));
  }
}

TEST_CASE("no run of a larger skill with mistakes in it exceeds what either analysis proved") {
  attack_all("mistakes", with_mistakes, setting("PAL_ROUNDS", 16));
}

TEST_CASE("no run of a skill that was kept, with mistakes in it, exceeds what either analysis proved") {
  attack_all("kept", kept_with_mistakes, setting("PAL_ROUNDS", 60));
}
