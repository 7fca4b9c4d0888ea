// skill_endings [--share] [--seeds N] [--seed N] [--row N] [--list] [SKILL…]: runs skills in physics and
// holds what their completions say against what the simulator knows. Prints the table of
// docs/skills_endings.md. Ends with 1 if a row is false. Skills are chosen by name, one row by its number;
// --list prints the rows and their numbers and runs nothing. --share runs one row in sixty, with one seed.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tests/run/skills/endings/cases.hpp"
#include "tests/run/skills/endings/truth.hpp"
#include "tests/run/skills/support/physical_run.hpp"

namespace {

using namespace pal;
using namespace pal::test;

struct Wanted {
  std::uint64_t first = 1, last = 5;  // seeds
  std::size_t every = 1;
  std::vector<std::string> skills;
  std::optional<std::size_t> row;
  bool only_list = false;

  bool has(std::size_t number, const EndingCase& one) const {
    if (row) return number == *row;
    return number % every == 0 && (skills.empty() || std::ranges::find(skills, one.skill) != skills.end());
  }
};

/// What the runs of one row that ended with the same code came to.
struct Row {
  int count = 0;
  std::string name;
  double least = 1e9, greatest = -1e9;
  std::string untrue;
  std::string reason;
};

struct RunEnd {
  int code = 0;
  Judgement judgement;
  std::string reason;
};

// An arm that has hit something gives way for 0.3 s, and then stands.
constexpr runtime::Time gives_way = std::chrono::milliseconds(500);

constexpr double height_of_seed = 0.13;  // mm; a step of touch is 0.56 mm

RunEnd run_one(const EndingCase& one, const sim::Scene& scene, std::uint64_t seed) {
  // Another seed is another machine, too, and another height above what is met.
  sim::CellOptions options;
  options.seed = seed;
  options.machine_seed = seed;
  if (one.skill == "touch" || one.skill == "press" || one.skill == "rub")
    options.raise = height_of_seed * static_cast<double>(seed - 1);
  Workshop shop(scene, options);
  for (const Before& each : one.before) shop.run(each.skill, each.parameters);
  sim::Workcell& workcell = shop.cell().workcell();
  sim::Sample before;
  before.tool = workcell.tool().translation();
  before.tool_turn = Eigen::Quaterniond(workcell.tool().linear());
  const bool held = workcell.holds_part();
  const auto things = shop.parts();
  const runtime::Outcome outcome = shop.run(one.skill, one.parameters);
  shop.cell().rest(gives_way);
  const Ended ended{shop, outcome, one.parameters, before, held, things};
  return {outcome.code, judge(ended), outcome.fault ? outcome.reason : std::string()};
}

std::string words(const Parameters& parameters) {
  std::string text;
  for (const runtime::ParameterValue& each : parameters)
    text += (text.empty() ? "" : ", ") + each.name + " " +
            (each.text ? *each.text : fmt::format("{:g}", each.value));
  return text.empty() ? "defaults" : text;
}

// True if what was said is so in all runs.
bool write_rows(const EndingCase& one, const Wanted& wanted) {
  std::optional<ChangedScene> changed;
  if (!one.lines.empty()) changed.emplace(one.scene, one.lines);
  const sim::Scene scene = changed ? changed->scene() : test::scene(one.scene);
  std::map<int, Row> rows;
  for (std::uint64_t seed = wanted.first; seed <= wanted.last; ++seed) {
    const RunEnd end = run_one(one, scene, seed);
    Row& row = rows[end.code];
    ++row.count;
    row.name = end.judgement.name;
    row.least = std::min(row.least, end.judgement.figure);
    row.greatest = std::max(row.greatest, end.judgement.figure);
    if (!end.judgement.untrue.empty()) row.untrue = fmt::format("seed {}: {}", seed, end.judgement.untrue);
    if (!end.reason.empty()) row.reason = end.reason;
  }
  bool good = true;
  for (const auto& [code, row] : rows) {
    good = good && row.untrue.empty();
    std::cout << fmt::format("| {} | {} | {} | {} | {} of {}: {} | {:.2f} to {:.2f} {} | {} |\n", one.skill,
                             one.scene, one.begins, words(one.parameters), row.count,
                             wanted.last - wanted.first + 1, code, row.least, row.greatest, row.name,
                             row.untrue.empty() ? row.reason.substr(0, 90) : "**false**: " + row.untrue)
              << std::flush;
  }
  return good;
}

}  // namespace

int main(int count, char** arguments) {
  Wanted wanted;
  const std::span words(arguments + 1, static_cast<std::size_t>(count - 1));
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (word == "--share") {
      wanted.last = 1;
      wanted.every = 60;
    } else if (word == "--seeds" && i + 1 < words.size()) {
      wanted.last = std::stoul(words[++i]);
    } else if (word == "--seed" && i + 1 < words.size()) {
      wanted.first = wanted.last = std::stoul(words[++i]);
    } else if (word == "--row" && i + 1 < words.size()) {
      wanted.row = std::stoul(words[++i]);
    } else if (word == "--list") {
      wanted.only_list = true;
    } else {
      wanted.skills.emplace_back(word);
    }
  }
  try {
    if (!wanted.only_list)
      std::cout << "| skill | scene | begins | parameters | ends: code | physics shows | reason |\n"
                   "| --- | --- | --- | --- | --- | --- | --- |\n";
    bool good = true;
    std::size_t number = 0;
    for (const EndingCase& one : ending_cases()) {
      const std::size_t here = number++;
      if (!wanted.has(here, one)) continue;
      if (wanted.only_list)
        std::cout << fmt::format("{} | {} | {} | {} | {}\n", here, one.skill, one.scene, one.begins,
                                 ::words(one.parameters));
      else
        good = write_rows(one, wanted) && good;
    }
    return good ? 0 : 1;
  } catch (const std::exception& problem) {
    std::cerr << "skill_endings: " << problem.what() << '\n';
    return 2;
  }
}
