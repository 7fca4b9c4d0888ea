// Systems from books and papers whose answers are published. Each file in published/ says where it is from.
#include <catch2/catch.hpp>
#include <fstream>
#include <iostream>
#include <sstream>

#include "analyzer/compositional/compositional.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

std::unique_ptr<test::Skill> published(const std::string& name) {
  auto skill =
      test::skill_from_files({std::string(PAL_SOURCE_DIR) + "/tests/figures/published/" + name + ".pal"});
  INFO(test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  return skill;
}

struct Answer {
  const char* file;
  const char* requirement;
  Nanoseconds microseconds;
};

const Answer answers[] = {
    {"liu_layland_1973", "one", 1'000},
    {"liu_layland_1973", "two", 4'000},
    {"burns_wellings_set_c", "c", 5'000},
    {"burns_wellings_set_c", "b", 15'000},
    {"burns_wellings_set_c", "a", 80'000},
    {"burns_wellings_set_d", "a", 3'000},
    {"burns_wellings_set_d", "b", 6'000},
    {"burns_wellings_set_d", "c", 20'000},
    {"lehoczky_1990", "one", 26'000},
    {"lehoczky_1990", "two", 118'000},
    {"sha_goodenough_1990", "three", 300'000},
    {"davis_2007_can", "a", 2'000},
    {"davis_2007_can", "b", 3'000},
    {"davis_2007_can", "c", 3'500},
    {"buttazzo_table_4_3", "four", 10'000},
    {"buttazzo_exercise_4_3", "one", 1'000},
    {"buttazzo_exercise_4_3", "two", 3'000},
    {"buttazzo_exercise_4_3", "three", 10'000},
    {"liu_2000_time_demand", "one", 1'000},
    {"liu_2000_time_demand", "two", 2'500},
    {"liu_2000_time_demand", "three", 4'750},
    {"liu_2000_time_demand", "four", 9'000},
};

const Verdict& of(const Analysis& analysis, const std::string& requirement) {
  for (const Verdict& verdict : analysis.verdicts) {
    if (verdict.requirement == requirement) return verdict;
  }
  throw std::runtime_error("no requirement " + requirement);
}

/// Times in the files may be a nanosecond short, so that answers are short by one a job.
bool is(const std::optional<Duration>& bound, Nanoseconds microseconds) {
  if (!bound) return false;
  const Nanoseconds short_by = microseconds * 1000 - bound->count();
  return short_by >= 0 && short_by < 50;
}

}  // namespace

TEST_CASE("compositional bounds are the published responses") {
  for (const Answer& answer : answers) {
    const auto skill = published(answer.file);
    const Analysis analysis = analyze_compositionally(*skill->problem);
    const Verdict& verdict = of(analysis, answer.requirement);
    INFO(answer.file << " " << answer.requirement << ": " << (verdict.bound ? verdict.bound->count() : -1)
                     << " " << verdict.explanation);
    CHECK(is(verdict.bound, answer.microseconds));
    CHECK(verdict.state == Verdict::State::holds);
  }
}

TEST_CASE("exact bounds are the published responses") {
  int exact = 0;
  std::string last;
  Analysis analysis;
  for (const Answer& answer : answers) {
    const auto skill = published(answer.file);
    Options options;
    options.max_states = 10'000;
    if (last != answer.file) analysis = analyze(*skill->problem, options);
    last = answer.file;
    const Verdict& verdict = of(analysis, answer.requirement);
    INFO(answer.file << " " << answer.requirement << ": " << (verdict.bound ? verdict.bound->count() : -1)
                     << " " << verdict.explanation);
    CHECK(verdict.state != Verdict::State::fails);
    if (!verdict.exact || !verdict.bound) {
      std::cout << answer.file << " " << answer.requirement << ": not within 10000 classes\n";
      continue;
    }
    ++exact;
    CHECK(is(verdict.bound, answer.microseconds));
  }
  std::cout << exact << " published responses exactly\n";
  CHECK(exact > 10);
}

TEST_CASE("what is published as schedulable holds, and what is not does not") {
  const auto set_a = published("burns_wellings_set_a");
  const Analysis a = analyze_compositionally(*set_a->problem);
  CHECK(of(a, "b").state == Verdict::State::holds);
  CHECK(of(a, "c").state == Verdict::State::holds);
  CHECK(of(a, "a").state == Verdict::State::undecided);
  Options options;
  options.max_states = 20'000;
  const Analysis exact = analyze(*set_a->problem, options);
  CHECK(of(exact, "a").state != Verdict::State::holds);
  for (const char* file : {"burns_wellings_set_b", "baker_2006_quiz", "liu_layland_1973"}) {
    const auto skill = published(file);
    INFO(file);
    const Analysis analysis = analyze_compositionally(*skill->problem);
    for (const Verdict& verdict : analysis.verdicts) {
      CHECK(verdict.state == Verdict::State::holds);
    }
  }
}

TEST_CASE("Liu and Layland: the second task's time may be no longer") {
  std::ifstream file(std::string(PAL_SOURCE_DIR) + "/tests/figures/published/liu_layland_1973.pal");
  std::stringstream text;
  text << file.rdbuf();
  std::string longer = text.str();
  const std::string time = "TIME work OF SD-two : 1999999 ns";
  REQUIRE(longer.find(time) != std::string::npos);
  longer.replace(longer.find(time), time.size(), "TIME work OF SD-two : 2000010 ns");
  const auto skill = test::sound_skill(longer);
  const Analysis analysis = analyze_compositionally(*skill->problem);
  const Verdict& verdict = of(analysis, "two");
  CHECK((!verdict.bound || verdict.bound->count() > 5'000'000 - 50));
}
