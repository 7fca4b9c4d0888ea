// What must not change when a program is told in another way, and what may only grow.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <random>

#include "analyzer/exact/exact.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/wider.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;
using test::replaced;

namespace {

/// By requirement: the bound, -1 if it fails without one, nothing if that is not known for sure.
using Known = std::map<std::string, std::optional<std::int64_t>>;

Known known(const Problem& problem) {
  Options options;
  options.max_states = setting("PAL_CLASSES", 3'000);
  Known all;
  for (const Verdict& verdict : analyze_exactly(problem, options).verdicts) {
    if (verdict.measure == Requirement::Measure::load) continue;
    auto& of = all[verdict.requirement];
    if (verdict.exact) of = verdict.bound ? verdict.bound->count() : -1;
  }
  return all;
}

Known known(const std::string& text) {
  const auto skill = test::any_skill(text);
  return skill->problem ? known(*skill->problem) : Known{};
}

/// The modules in another order, and the lines of the environment.
std::string reordered(const std::string& text, std::mt19937_64& engine) {
  const std::vector<std::string> heads{"\nSensor Driver:",      "\nLogical Sensor:", "\nMachine Controller:",
                                       "\nContingency Module:", "\nSkill Module:",   "\nENVIRONMENT"};
  std::vector<std::size_t> starts;
  for (const std::string& head : heads) {
    const std::size_t at = text.find(head);
    if (at != std::string::npos) starts.push_back(at);
  }
  std::sort(starts.begin(), starts.end());
  std::vector<std::string> modules;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
    modules.push_back(text.substr(starts[i], starts[i + 1] - starts[i]));
  std::shuffle(modules.begin(), modules.end(), engine);
  std::string made = text.substr(0, starts.front());
  for (const std::string& module : modules) made += module;
  const std::string environment = text.substr(starts.back() + 1);
  std::vector<std::string> lines;
  for (std::size_t at = environment.find('\n') + 1; at < environment.size();) {
    const std::size_t end = environment.find('\n', at);
    lines.push_back(environment.substr(at, end - at + 1));
    at = end + 1;
  }
  std::shuffle(lines.begin(), lines.end() - 1, engine);
  made += "\n" + environment.substr(0, environment.find('\n') + 1);
  for (const std::string& line : lines) made += line;
  return made;
}

/// With a processor, a module and a device that have nothing to do with the rest.
std::string with_company(const std::string& text) {
  std::string made =
      replaced(text, "DEVICE robot\n", "DEVICE robot\nDEVICE metronome\nMESSAGE beat : SIGNAL\n");
  made = replaced(made, "  SKILL METHOD", "  MACHINE CONTROLLER MC9\n  SKILL METHOD");
  made =
      replaced(made, "\nENVIRONMENT cell\n",
               "\nMachine Controller: MC9\nACTIVITY idle\nBEGIN\nREPEAT\nWTM( beat from metronome )\nidle\n"
               "UNTIL( forever )\nEND\nENVIRONMENT cell\n  PROCESSOR P9\n  PLACE MC9 ON P9 PRIORITY 2\n"
               "  TIME idle : 1 ms\n  DEVICE metronome EVENT beat EVERY 6 ms PHASE 0 ms\n");
  return made;
}

std::string wrong(const Known& before, const Known& after,
                  const std::function<bool(std::int64_t, std::int64_t)>& fits, std::size_t& compared) {
  for (const auto& [name, was] : before) {
    const auto found = after.find(name);
    if (!was || found == after.end() || !found->second) continue;
    ++compared;
    if (!fits(*was, *found->second))
      return name + " was " + std::to_string(*was) + ", is " + std::to_string(*found->second);
  }
  return {};
}

}  // namespace

TEST_CASE(
    "a program told in another way has the same bounds, and one with greater worst times no smaller ones") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 20);
  std::size_t compared = 0;
  const auto same = [](std::int64_t was, std::int64_t is) { return was == is; };
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    std::mt19937_64 engine(seed);
    const std::string text = test::RandomCell(seed, 4, static_cast<int>(seed % 3)).text();
    const auto skill = test::any_skill(text);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    const Known before = known(*skill->problem);
    std::vector<std::pair<std::string, std::string>> found;
    const std::string names =
        replaced(replaced(replaced(text, "MC1", "Zebra"), "LS1", "Aardvark"), "SM1", "Middle");
    found.emplace_back("renamed", wrong(before, known(names), same, compared));
    found.emplace_back("reordered", wrong(before, known(reordered(text, engine)), same, compared));
    found.emplace_back("with company", wrong(before, known(with_company(text)), same, compared));

    pan::Network network = skill->specification.skills.front();
    pan::Environment environment = skill->specification.environments.front();
    test::scale(network, environment, 7);
    Diagnostics diagnostics;
    const auto scaled = make_problem(network, environment, diagnostics);
    REQUIRE(scaled);
    found.emplace_back(
        "scaled",
        wrong(
            before, known(*scaled),
            [](std::int64_t was, std::int64_t is) { return was < 0 ? is < 0 : is == 7 * was; }, compared));

    environment = skill->specification.environments.front();
    Interval& grown = environment.activities[engine() % environment.activities.size()].time;
    grown.worst += std::chrono::milliseconds(1);
    const auto greater = make_problem(skill->specification.skills.front(), environment, diagnostics);
    REQUIRE(greater);
    found.emplace_back(
        "grown",
        wrong(
            before, known(*greater),
            [](std::int64_t was, std::int64_t is) { return is < 0 || (was >= 0 && is >= was); }, compared));
    for (const auto& [how, what] : found) {
      if (!what.empty()) std::cout << "seed " << seed << " " << how << ": " << what << std::endl;
      CHECK(what == "");
    }
  }
  std::cout << compared << " bounds compared\n";
  CHECK(compared > 0);
}

TEST_CASE("a device on request equals a module on a processor of its own") {
  // Both serve one request at a time, and answer those that were withdrawn in vain.
  const std::string device = test::program("served/by_device");
  const std::string module = test::program("served/by_module");
  std::size_t compared = 0;
  for (const std::string answer : {"0 ms", "0 TO 2 ms", "3 ms"}) {
    for (const std::string limit : {"0 ms", "2 ms", "3 ms"}) {
      for (const std::string processor : {"PROCESSOR P", "PROCESSOR P NONPREEMPTIVE"}) {
        const auto with = [&](std::string text) {
          text = replaced(text, "ON REQUEST 3 ms", "ON REQUEST " + answer);
          text = replaced(text, "TIME serve : 3 ms", "TIME serve : " + answer);
          text = replaced(text, "WITHIN 2 ms", "WITHIN " + limit);
          return replaced(text, "PROCESSOR P\n", processor + "\n");
        };
        INFO(answer << ", " << limit << ", " << processor);
        const Known by_device = known(with(device));
        CHECK(wrong(by_device, known(with(module)), std::equal_to<>(), compared) == "");
      }
    }
  }
  CHECK(compared > 70);
}
