// Figures of operations and of the run-time system (docs/internals/benchmarks.md): benchmark_operations [REPETITIONS]
#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "operations/load.hpp"
#include "operations/step_log.hpp"
#include "runtime_system/client.hpp"
#include "runtime_system/server.hpp"
#include "sim/cell/cell.hpp"
#include "sim/program/cell_runner.hpp"
#include "sim/program/instruments.hpp"

using namespace pal;

namespace {

constexpr const char* endless =
    R"({"operation-format": 1, "name": "endless", "icons": [{"id": "start", "kind": "start", "next": "a"},)"
    R"({"id": "a", "kind": "skill", "skill": "relative-move", "parameters": {"dz": -2}, "next": "b", "error": "end"},)"
    R"({"id": "b", "kind": "skill", "skill": "relative-move", "parameters": {"dz": 2}, "next": "a", "error": "end"},)"
    R"({"id": "end", "kind": "exit"}]})";

operations::Program endless_program() {
  MemoryFileSystem files;
  files.add("o", endless);
  SourceManager sources;
  Diagnostics diagnostics;
  return *operations::load(files, sources, "o", diagnostics);
}

double wall() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

long resident_kilobytes() {
  std::ifstream in("/proc/self/statm");
  long all = 0, resident = 0;
  in >> all >> resident;
  return resident * (::sysconf(_SC_PAGESIZE) / 1024);
}

/// Skills of no length: what is left is the executor's.
class Nothing final : public operations::SkillRunner {
 public:
  operations::SkillResult run(const std::string&, const std::vector<operations::Parameter>&) override {
    const double now = wall();
    if (ended_ > 0) {
      longest = std::max(longest, now - ended_);
      sum += now - ended_;
    }
    time_ += std::chrono::seconds(1);
    ended_ = wall();
    return {};
  }
  void delay(Duration length) override { time_ += length; }
  Duration now() const override { return time_; }
  void stop() noexcept override {}
  void allow() override {}
  double longest = 0, sum = 0;

 private:
  double ended_ = 0;
  Duration time_{};
};

void between_skills() {
  Nothing runner;
  std::ostringstream text;
  operations::StepLog log(text);
  operations::Executor executor(endless_program(), runner, &log);
  executor.run(1'000);
  const long before = resident_kilobytes();
  const std::size_t written = text.str().size();
  executor.run(9'000);
  const long grown = resident_kilobytes() - before;
  const std::string whole = text.str();
  std::cout << fmt::format("from a skill to the next, 10,000 steps: mean {:.1f} us, longest {:.1f} us\n",
                           runner.sum / 9'999 * 1e6, runner.longest * 1e6)
            << fmt::format(
                   "lines of the log: {}; memory grew by {} kB over 9,000 steps, the log itself by {} kB\n",
                   std::count(whole.begin(), whole.end(), '\n'), grown, (whole.size() - written) / 1024);
}

/// 10,000 steps in the workcell. Gives the log.
std::string in_the_cell(std::size_t steps, bool tell) {
  const sim::Scene scene = sim::find_scene("flat", {PAL_SCENE_DIR});
  sim::CellOptions options;
  options.keep_log = false;
  sim::Cell cell(scene, options);
  const auto known = workcell::linked_skills();
  workcell::CellRunner runner(cell, known, runtime::CostPolicy::random, 1);
  std::ostringstream text;
  operations::StepLog log(text);
  operations::Executor executor(endless_program(), runner, &log);
  executor.run(steps / 10);
  const long before = resident_kilobytes();
  const double begin = wall();
  executor.run(steps - steps / 10);
  if (tell)
    std::cout << fmt::format(
        "{} skills in the workcell: {:.1f} s, memory grew by {} kB from the first tenth on, state {}\n",
        steps, wall() - begin, resident_kilobytes() - before, operations::name(executor.state()));
  return text.str();
}

/// Processor time of the simulation's thread for some skills, with so many clients that read nothing.
double cost(int clients) {
  runtime_system::ServerOptions doors;
  doors.token = "token";
  runtime_system::Server server(doors);
  const sim::Scene scene = sim::find_scene("flat", {PAL_SCENE_DIR});
  sim::CellOptions options;
  options.keep_log = false;
  options.watch = [&](sim::Workcell& cell) {
    return std::make_unique<workcell::WatchedWorld>(cell,
                                                    std::vector{workcell::instrument_watcher(cell, server)});
  };
  sim::Cell cell(scene, options);
  const auto known = workcell::linked_skills();
  workcell::CellRunner runner(cell, known, runtime::CostPolicy::random, 1, workcell::OnInterrupt::leave);
  runtime_system::Desk desk(runner, workcell::templates_of(known), server);
  server.start(desk);
  std::vector<std::unique_ptr<runtime_system::Client>> sleepers;
  for (int i = 0; i < clients; ++i) {
    sleepers.push_back(std::make_unique<runtime_system::Client>("127.0.0.1", server.port()));
    sleepers.back()->call("hello", R"({"token": "token"})");
    sleepers.back()->call("watch", R"({"telemetry": 0.02})");
  }
  while (clients > 0 && !server.wanted()) ::usleep(1000);
  const runtime_system::ClientId me = desk.enter("benchmark");
  double spent = 0;
  for (int i = 0; i < 40; ++i) {
    desk.ask(me, runtime_system::RunSkill{"relative-move", {{"dz", i % 2 == 0 ? -30.0 : 30.0, {}, {}}}},
             [](const runtime_system::Reply&) {});
    const double begin = processor_time();
    desk.work();
    spent += processor_time() - begin;
  }
  server.stop();
  return spent;
}

double median(std::vector<double> figures) {
  std::sort(figures.begin(), figures.end());
  return figures[figures.size() / 2];
}

}  // namespace

int main(int count, char** arguments) {
  const int repetitions = count > 1 ? std::atoi(arguments[1]) : 7;
  between_skills();
  in_the_cell(10'000, true);
  std::cout << "same bytes of 500 steps for the same seed: "
            << (in_the_cell(500, false) == in_the_cell(500, false) ? "yes\n" : "NO\n");
  std::vector<double> alone, watched;
  for (int i = 0; i < repetitions; ++i) {
    alone.push_back(cost(0));
    watched.push_back(cost(1));
  }
  std::cout << fmt::format(
      "a client that reads nothing costs the simulation's thread {:+.2f} % (medians of {}: {:.3f} s and "
      "{:.3f} s)\n",
      100 * (median(watched) / median(alone) - 1), repetitions, median(watched), median(alone));
}
