// What was run in the cell: each skill and operation with its steps, in a database on the disk.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "operations/executor.hpp"
#include "server/event.hpp"

namespace pal::server {

/// One execution. A run that was paused or stopped and goes on is the same one.
struct RunRecord {
  enum class Kind { skill, operation };
  std::uint64_t run = 0;  // from 1, also over starts of the server
  Kind kind = Kind::skill;
  std::string name;  // of the skill or operation
  WallTime begun{};
  std::optional<WallTime> ended{};
  Duration begin{};  // of the cell
  std::optional<Duration> end{};
  std::string by;     // the client that began it
  std::string state;  // ended, failed, stopped, paused, running, or broken off: the server ended
  std::optional<int> code{};
  std::string reason;
  std::size_t steps = 0;
};

struct RunPage {
  std::vector<RunRecord> runs;
  bool more = false;  // there are older ones
};

struct RunSteps {
  struct Each {
    std::string step;        // as operations::log_line()
    std::string parameters;  // all of them, defaults too: an object of JSON
  };
  RunRecord run;
  std::optional<std::string> text;  // of the operation's main file
  std::vector<Each> steps;
  bool more = false;  // there are later ones
};

/// Executions of one skill, the newest first.
struct StepPage {
  struct Each {
    std::uint64_t run = 0;
    std::string name;  // of the run
    WallTime begun{};  // the run
    RunSteps::Each step;
  };
  std::vector<Each> steps;
  bool more = false;  // there are older ones
};

struct RunHistoryLimits {
  std::uint64_t most_runs = 100'000;
  std::uint64_t most_bytes = std::uint64_t{256} << 20;  // of the database; the oldest runs go first
};

/// For all threads. What is noted is written by a thread of its own, so that the disk keeps nobody waiting.
class RunHistory {
 public:
  /// The database is FILE; empty: a file of its own that ends with this. Runs that have no end were broken
  /// off. Throws StoreProblem.
  explicit RunHistory(const std::string& file, RunHistoryLimits limits = {});
  /// All that was noted is on the disk before it returns.
  ~RunHistory();
  RunHistory(const RunHistory&) = delete;
  RunHistory& operator=(const RunHistory&) = delete;

  /// The number of the new run. `text`: of the operation's main file.
  std::uint64_t begin(RunRecord run, std::optional<std::string> text = std::nullopt);
  /// `all`: the skill's parameters, with those that have their defaults.
  void step(std::uint64_t run, const operations::Step& step, std::vector<operations::Parameter> all);
  /// It goes on, or has halted.
  void change(std::uint64_t run, std::string state, std::optional<Duration> end, std::optional<int> code,
              std::string reason);
  /// Waits while too much is noted that is not written. For operations in which no time passes.
  void make_room();

  /// The newest first, those below `before`; with a name only its runs. Throws StoreProblem.
  RunPage list(std::optional<std::uint64_t> before, std::size_t limit, const std::string& name) const;
  /// The run with its steps above `after`. Throws StoreProblem.
  RunSteps read(std::uint64_t run, std::uint64_t after, std::size_t limit) const;
  /// Of all runs that began this skill, below the run `before`. Throws StoreProblem.
  StepPage steps_of(const std::string& skill, std::optional<std::uint64_t> before, std::size_t limit) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::server
