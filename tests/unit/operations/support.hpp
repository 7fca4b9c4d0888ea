// Operations from strings, and a cell in which every skill takes a second.
#pragma once

#include <catch2/catch.hpp>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"
#include "operations/load.hpp"

namespace pal::test {

/// The program of `text`, which must have no errors.
inline operations::Program program_of(const std::string& text) {
  MemoryFileSystem files;
  files.add("o.op.json", text);
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = operations::load(files, sources, "o.op.json", diagnostics);
  REQUIRE(program);
  operations::check_shape(*program, diagnostics);
  REQUIRE_FALSE(diagnostics.has_errors());
  return *program;
}

inline std::string operation(const std::string& icons, const std::string& more = "") {
  return R"({"operation-format": 1, "name": "o", "icons": [{"id": "start", "kind": "start", "next": "a"}, )" +
         icons + "]" + more + "}";
}

/// Two skills, the second behind a CASE, and an endless way back for code 1.
inline const char* const looping =
    R"({"id": "a", "kind": "skill", "skill": "go", "parameters": {"far": 3}, "next": "case"},)"
    R"({"id": "case", "kind": "case", "ways": [{"codes": [0], "to": "b"}, {"codes": [1], "to": "a"}]},)"
    R"({"id": "b", "kind": "skill", "skill": "back", "next": "end"}, {"id": "end", "kind": "exit"})";

class ScriptedRunner final : public operations::SkillRunner {
 public:
  std::optional<std::string> initialise() override {
    ++initialised;
    return problem;
  }
  operations::SkillResult run(const std::string& skill, const std::vector<operations::Parameter>& parameters,
                              std::optional<Duration> limit) override {
    ran.push_back(skill);
    last_parameters = parameters;
    last_limit = limit;
    time += std::chrono::seconds(1);
    if (during) during();
    if (stopped) return {operations::SkillResult::Kind::stopped, 9, "stopped"};
    if (limit && lasts > *limit) {
      operations::SkillResult result;
      result.over_time = true;
      return result;
    }
    int code = 0;
    if (!codes.empty()) {
      code = codes.front();
      codes.pop_front();
    }
    using Kind = operations::SkillResult::Kind;
    return {code == 0   ? Kind::normal
            : code == 9 ? Kind::error
                        : Kind::contingency,
            code, "as told", false, figures};
  }
  void ask(const operations::Question& question) override { asked.push_back(question); }
  operations::Reply answer() override {
    if (stopped) return {{}, {}, true};
    if (nobody) return {{}, "nobody is there", false};
    if (answers.empty()) return {};
    const auto choice = answers.front();
    answers.pop_front();
    return {choice, {}, false};
  }
  void withdraw() override { ++withdrawn; }
  std::optional<std::string> zero(const std::string& sensor) override {
    zeroed.push_back(sensor);
    if (during_zero) during_zero();
    return zero_problem;
  }
  bool delay(Duration length) override {
    time += length;
    if (during_delay) during_delay();
    return !stopped;
  }
  operations::Reading sense(const std::string& sensor) override {
    sensed.push_back(sensor);
    time += std::chrono::milliseconds(10);
    if (stopped) return {{}, {}, true};
    if (readings.empty()) return {{}, "no answer", false};
    const double reading = readings.front();
    if (readings.size() > 1) readings.pop_front();
    return {reading, {}, false};
  }
  Duration now() const override { return time; }
  void stop() noexcept override { stopped = true; }
  void allow() override { stopped = false; }

  std::deque<int> codes;  // of the next skills; then 0
  std::vector<std::string> ran;
  std::vector<operations::Parameter> last_parameters;
  std::optional<Duration> last_limit;
  Duration lasts{};                         // a skill; longer than its limit, it is ended
  std::vector<operations::Figure> figures;  // that each skill reports
  std::vector<operations::Question> asked;
  std::deque<std::optional<std::size_t>> answers;  // what answer() gives; then nothing yet
  bool nobody = false;
  int withdrawn = 0;
  std::vector<std::string> zeroed;
  std::optional<std::string> zero_problem;
  std::deque<double> readings;  // of the next tests and waits; the last one stays; none: the sensor fails
  std::vector<std::string> sensed;
  std::function<void()> during, during_delay, during_zero;
  std::optional<std::string> problem;
  int initialised = 0;
  bool stopped = false;
  Duration time{};
};

}  // namespace pal::test
