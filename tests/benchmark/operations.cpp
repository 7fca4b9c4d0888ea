// Figures of operations and of the server (docs/internals/benchmarks.md): benchmark_operations [ROW
// …]
#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "operations/load.hpp"
#include "operations/step_log.hpp"
#include "programs/workcell/session/cell_runner.hpp"
#include "programs/workcell/session/instruments.hpp"
#include "server/client.hpp"
#include "server/server.hpp"
#include "sim/cell/cell.hpp"

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

/// At once: some rows take long.
void tell(const std::string& line) {
  std::cout << line << std::endl;
}

/// Skills of no length: what is left is the executor's.
class Nothing final : public operations::SkillRunner {
 public:
  operations::SkillResult run(const std::string&, const std::vector<operations::Parameter>&,
                              std::optional<Duration>) override {
    const double now = wall();
    if (ended_ > 0) gaps.push_back(now - ended_);
    time_ += std::chrono::seconds(1);
    ended_ = wall();
    return {};
  }
  bool delay(Duration length) override {
    time_ += length;
    return true;
  }
  Duration now() const override { return time_; }
  void stop() noexcept override {}
  void allow() override {}
  std::vector<double> gaps;  // s

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
  std::sort(runner.gaps.begin(), runner.gaps.end());
  tell(fmt::format(
      "from a skill to the next, 10,000 steps: median {:.1f} us, 99.9 % {:.1f} us, longest {:.1f} us",
      runner.gaps[runner.gaps.size() / 2] * 1e6, runner.gaps[runner.gaps.size() * 999 / 1000] * 1e6,
      runner.gaps.back() * 1e6));
  tell(fmt::format("lines of the log: {}; memory grew by {} kB over 9,000 steps, the log itself by {} kB",
                   std::count(whole.begin(), whole.end(), '\n'), grown, (whole.size() - written) / 1024));
}

/// So many skills in the workcell. Gives the log.
std::string in_the_cell(std::size_t steps, bool telling) {
  const sim::Scene scene = sim::find_scene("flat", {PAL_SCENE_DIR});
  sim::CellOptions options;
  options.keep_log = false;
  sim::Cell cell(scene, options);
  const auto known = workcell::installed_skills();
  workcell::CellRunner runner(cell, known, runtime::CostPolicy::random, 1);
  std::ostringstream text;
  operations::StepLog log(text);
  operations::Executor executor(endless_program(), runner, &log);
  executor.run(steps / 10);
  const long before = resident_kilobytes();
  const double begin = wall();
  executor.run(steps - steps / 10);
  const std::string log_text = text.str();
  if (telling)
    tell(fmt::format(
        "{} skills in the workcell: {:.0f} s, {:.0f} s of the cell; memory grew by {} kB from the first "
        "tenth on, of which the log {} kB; {} lines; state {} {}",
        steps, wall() - begin, std::chrono::duration<double>(runner.now()).count(),
        resident_kilobytes() - before, (log_text.size() - log_text.size() / 10) / 1024,
        std::count(log_text.begin(), log_text.end(), '\n'), operations::name(executor.state()),
        executor.reason()));
  return log_text;
}

/// A served cell whose simulation's processor time is measured.
class ServedCell {
 public:
  ServedCell() : server_(server_options()) {
    sim::CellOptions options;
    options.keep_log = false;
    options.watch = [this](sim::Workcell& cell) {
      return std::make_unique<workcell::WatchedWorld>(
          cell, std::vector{workcell::instrument_watcher(cell, server_)});
    };
    cell_.emplace(sim::find_scene("flat", {PAL_SCENE_DIR}), options);
    runner_.emplace(*cell_, known_, runtime::CostPolicy::random, 1, workcell::OnInterrupt::leave);
    desk_.emplace(*runner_, workcell::templates_of(known_), server_);
    server_.start(*desk_);
    me_ = desk_->enter("benchmark");
  }
  ~ServedCell() { server_.stop(); }
  ServedCell(const ServedCell&) = delete;
  ServedCell& operator=(const ServedCell&) = delete;

  /// Seconds of processor time of this thread, which simulates, for `skills` skills.
  double work(int skills) {
    double spent = 0;
    for (int i = 0; i < skills; ++i) {
      const double dz = down_ ? 30.0 : -30.0;
      down_ = !down_;
      desk_->ask(me_, server::RunSkill{"relative-move", {{"dz", dz, {}, {}}}}, [](const server::Reply&) {});
      const double begin = processor_time();
      desk_->work();
      spent += processor_time() - begin;
    }
    return spent;
  }
  /// Asks for everything and reads nothing.
  std::unique_ptr<server::Client> sleeper() {
    auto client = std::make_unique<server::Client>("127.0.0.1", server_.port());
    client->call("hello", R"({"token": "token"})");
    client->call("watch", R"({"telemetry": 0.02})");
    while (!server_.wanted()) ::usleep(1000);
    return client;
  }
  void wait_until_alone() {
    while (server_.wanted()) ::usleep(1000);
  }

 private:
  static server::ServerOptions server_options() {
    server::ServerOptions result;
    result.tokens.programmer = "token";
    return result;
  }
  server::Server server_;
  std::vector<workcell::KnownSkill> known_ = workcell::installed_skills();
  std::optional<sim::Cell> cell_;
  std::optional<workcell::CellRunner> runner_;
  std::optional<server::Desk> desk_;
  server::ClientId me_ = 0;
  bool down_ = false;
};

double median(std::vector<double> figures) {
  std::sort(figures.begin(), figures.end());
  return figures[figures.size() / 2];
}

/// In turn without and with the client, in one cell, so that both meet the same machine.
void sleeping_client() {
  constexpr int rounds = 25, skills = 4;
  ServedCell cell;
  cell.work(skills);
  std::vector<double> ratios;
  double alone = 0, watched = 0;
  for (int i = 0; i < rounds; ++i) {
    cell.wait_until_alone();
    const double without = cell.work(skills);
    const auto sleeper = cell.sleeper();
    const double with = cell.work(skills);
    alone += without;
    watched += with;
    ratios.push_back(with / without);
  }
  tell(
      fmt::format("a client that reads nothing costs the simulation's thread {:+.2f} % (median of {} pairs; "
                  "sums {:.2f} s and {:.2f} s, {:+.2f} %)",
                  100 * (median(ratios) - 1), rounds, watched, alone, 100 * (watched / alone - 1)));
}

void events() {
  constexpr int count = 50'000;
  server::ServerOptions options;
  options.tokens.programmer = "token";
  server::Server server(options);
  Nothing runner;
  server::Desk desk(runner, {}, server);
  server.start(desk);
  server::Client client("127.0.0.1", server.port());
  client.call("hello", R"({"token": "token"})");
  client.call("watch");
  const double begin = wall();
  std::thread cell([&] {
    for (int i = 1; i <= count; ++i) {
      server.make_room();
      server.happened({static_cast<std::uint64_t>(i), {}, server::IconReached{"icon"}});
    }
  });
  int in_order = 0;
  while (in_order < count) {
    const auto text = client.next(std::chrono::seconds(10));
    if (!text) break;
    const auto message = nlohmann::json::parse(*text);
    if (message.value("method", "") != "event") continue;
    if (message["params"]["number"] != in_order + 1) break;
    ++in_order;
  }
  const double seconds = wall() - begin;
  cell.join();
  server.stop();
  tell(fmt::format("events at a client that reads: {} of {} in order, {:.0f} a second", in_order, count,
                   in_order / seconds));
}

void same_bytes() {
  tell(std::string("same bytes of 500 steps for the same seed: ") +
       (in_the_cell(500, false) == in_the_cell(500, false) ? "yes" : "NO"));
}

void ten_thousand() {
  tell("10,000 skills in the workcell: this takes some minutes …");
  in_the_cell(10'000, true);
}

struct Row {
  const char* name;
  void (*measure)();
};
constexpr Row rows[] = {{"next", between_skills},
                        {"events", events},
                        {"sleeper", sleeping_client},
                        {"same", same_bytes},
                        {"long", ten_thousand}};

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  for (const std::string& name : wanted) {
    if (std::any_of(std::begin(rows), std::end(rows), [&](const Row& row) { return name == row.name; }))
      continue;
    std::cerr << "benchmark_operations: there is no row '" << name
              << "'; there are next, events, sleeper, same, long\n";
    return 2;
  }
  for (const Row& row : rows)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), row.name) != wanted.end()) row.measure();
  return 0;
}
