// Two chains of sensors, of which a requirement needs one (docs/internals/slices.md).
#include <algorithm>
#include <catch2/catch.hpp>

#include "analyzer/analysis.hpp"
#include "analyzer/slice/cone.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

/// With the requirement of the file, or another one instead.
std::unique_ptr<test::Skill> seam_on(const std::string& workcell, const std::string& requirement = {}) {
  const std::string folder = "tests/reference/two_sensors/";
  std::string skill = test::project_file(folder + "skill.pal");
  if (!requirement.empty()) {
    const std::size_t from = skill.find("  REQUIREMENT");
    skill.replace(from, skill.find('\n', from) - from, "  REQUIREMENT " + requirement);
  }
  return test::sound_skill(skill + test::project_file(folder + workcell + ".pal"));
}

std::vector<std::string> left_out(const Problem& problem) {
  const Cone cone = cone_of(problem, problem.requirements.front());
  std::vector<std::string> names;
  for (const ThreadId t : cone.threads.ids()) {
    if (!cone.threads[t]) names.push_back(problem.threads[t].name);
  }
  for (const DeviceId d : cone.devices.ids()) {
    if (!cone.devices[d]) names.push_back(problem.devices[d].name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("a chain of sensors on its own processor has no influence") {
  const auto skill = seam_on("three");
  CHECK(left_out(*skill->problem) == std::vector<std::string>{"LS1", "SD1", "SM1.1", "camera"});
  const Verdict verdict = analyze(*skill->problem, AnalysisChoice::automatic).verdicts.front();
  CHECK(verdict.state == VerdictState::holds);
  CHECK(verdict.bound == Duration(7'900'000));
  CHECK(verdict.statistics.classes < 100'000);
}

// Its driver goes before what is measured, as often as the camera lets it; the rest of the chain goes after.
TEST_CASE("of a chain on the same processor only higher priorities are kept") {
  const auto skill = seam_on("one");
  CHECK(left_out(*skill->problem) == std::vector<std::string>{"LS1", "SM1.1", "camera"});
  const Verdict verdict = analyze(*skill->problem, AnalysisChoice::automatic).verdicts.front();
  CHECK(verdict.state == VerdictState::holds);
  REQUIRE(verdict.bound);
  CHECK(*verdict.bound <= Duration(8'300'000));
}

// The method asks the probe once before its blocks begin, after the camera. By then the first sample is older
// the longer the probe takes.
TEST_CASE("of a chain that is asked before the blocks begin only how long that takes is kept") {
  const auto skill =
      seam_on("three", "picture-age : AGE OF picture FROM camera AT TXM( step to MC1 ) AT MOST 200 ms");
  CHECK(left_out(*skill->problem) == std::vector<std::string>{"LS2", "SD2", "SM1.2", "probe"});
  const Verdict verdict = analyze(*skill->problem, AnalysisChoice::automatic).verdicts.front();
  CHECK(verdict.state == VerdictState::holds);
  REQUIRE(verdict.bound);
  CHECK(*verdict.bound <= Duration(169'650'000));
  CHECK(verdict.statistics.classes < 100'000);
}
