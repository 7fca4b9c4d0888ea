#include "server/run_history.hpp"

#include <fmt/format.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "operations/step_log.hpp"
#include "server/database.hpp"

namespace pal::server {
namespace {

constexpr int history_format = 1;
constexpr std::size_t most_notes_waiting = 10'000;

constexpr const char* run_columns =
    "run, kind, name, begun_ms, ended_ms, begin_ns, end_ns, by, state, code, reason, steps";

RunRecord record_of(const Query& row) {
  RunRecord result;
  result.run = static_cast<std::uint64_t>(row.number(0));
  result.kind = row.number(1) == 0 ? RunRecord::Kind::skill : RunRecord::Kind::operation;
  result.name = row.text(2);
  result.begun = WallTime(std::chrono::milliseconds(row.number(3)));
  if (!row.empty(4)) result.ended = WallTime(std::chrono::milliseconds(row.number(4)));
  result.begin = Duration(row.number(5));
  if (!row.empty(6)) result.end = Duration(row.number(6));
  result.by = row.text(7);
  result.state = row.text(8);
  if (!row.empty(9)) result.code = static_cast<int>(row.number(9));
  result.reason = row.text(10);
  result.steps = static_cast<std::size_t>(row.number(11));
  return result;
}

std::string json_of_parameters(const std::vector<operations::Parameter>& parameters) {
  auto json = nlohmann::ordered_json::object();
  for (const operations::Parameter& each : parameters)
    std::visit([&](const auto& value) { json[each.name] = value; }, each.value);
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

struct RunHistory::Parts {
  Parts(const std::string& file, RunHistoryLimits the_limits) : limits(the_limits), database(file) {
    try {
      prepare();
    } catch (const StoreProblem& problem) {
      refuse(Refusal::Why::failed, fmt::format("{}: {}", file, problem.refusal.message),
             "move the file away, and a new history begins");
    }
  }

  void prepare() {
    // What the program has committed outlives the program; after a power cut the file is whole, too.
    execute(database, "PRAGMA auto_vacuum=INCREMENTAL; PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;");
    if (pragma(database, "PRAGMA user_version") > history_format)
      refuse(Refusal::Why::failed, "it was written by a newer program");
    execute(database,
            "CREATE TABLE IF NOT EXISTS runs (run INTEGER PRIMARY KEY, kind INTEGER, name TEXT, begun_ms "
            "INTEGER, ended_ms INTEGER, begin_ns INTEGER, end_ns INTEGER, by TEXT, state TEXT, code INTEGER, "
            "reason TEXT, steps INTEGER, text TEXT);"
            "CREATE INDEX IF NOT EXISTS runs_by_name ON runs (name, run);"
            "CREATE TABLE IF NOT EXISTS steps (run INTEGER, number INTEGER, step TEXT, parameters TEXT, "
            "PRIMARY KEY (run, number)) WITHOUT ROWID;"
            "CREATE INDEX IF NOT EXISTS steps_by_skill ON steps (json_extract(step, '$.skill'), run, number);"
            "UPDATE runs SET state = 'broken off' WHERE state = 'running';");
    execute(database, fmt::format("PRAGMA user_version={}", history_format).c_str());
    Query last(database, "SELECT coalesce(max(run), 0) FROM runs");
    last.next();
    next_run = static_cast<std::uint64_t>(last.number(0)) + 1;
  }

  void note(std::function<void()> write) {
    {
      const std::lock_guard lock(mutex);
      waiting.push_back(std::move(write));
    }
    changed.notify_all();
  }
  void work() {
    for (;;) {
      std::deque<std::function<void()>> taken;
      {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return ending || !waiting.empty(); });
        if (waiting.empty()) return;
        taken.swap(waiting);
        writing = true;
      }
      write(taken);
      {
        const std::lock_guard lock(mutex);
        writing = false;
      }
      written.notify_all();
    }
  }
  void write(const std::deque<std::function<void()>>& all) {
    const std::lock_guard lock(on_database);
    try {
      execute(database, "BEGIN");
      for (const auto& each : all) each();
      keep_limits();
      execute(database, "COMMIT");
      execute(database, "PRAGMA incremental_vacuum(1000)");
      problem.reset();
    } catch (const StoreProblem& failed) {
      sqlite3_exec(database, "ROLLBACK", nullptr, nullptr, nullptr);
      problem = failed.refusal;
    }
  }
  void keep_limits() {
    for (;;) {
      Query count(database, "SELECT count(*), min(run) FROM runs");
      count.next();
      const bool large = bytes_of(database) > static_cast<std::int64_t>(limits.most_bytes);
      if (!large && count.number(0) <= static_cast<std::int64_t>(limits.most_runs)) return;
      if (count.number(0) == 0) return;
      const std::int64_t oldest = count.number(1);
      if (count.number(0) > 1) {
        Query(database, "DELETE FROM steps WHERE run = ?").put(1, oldest).run();
        Query(database, "DELETE FROM runs WHERE run = ?").put(1, oldest).run();
        continue;
      }
      // One run alone fills it: its first steps go.
      Query(database,
            "DELETE FROM steps WHERE number <= (SELECT min(number) + (max(number) - min(number)) / 4 FROM "
            "steps)")
          .run();
      return;
    }
  }
  /// So that a client that was told of a step finds it.
  void wait_until_written() {
    std::unique_lock lock(mutex);
    written.wait_for(lock, std::chrono::seconds(2), [this] { return waiting.empty() && !writing; });
  }

  const RunHistoryLimits limits;
  Database database;
  mutable std::mutex on_database;
  std::optional<Refusal> problem;  // of the last write

  std::mutex mutex;
  std::condition_variable changed, written;
  std::deque<std::function<void()>> waiting;
  std::uint64_t next_run = 1;
  bool writing = false, ending = false;
  std::thread writer;
};

RunHistory::RunHistory(const std::string& file, RunHistoryLimits limits)
    : parts_(std::make_unique<Parts>(file, limits)) {
  parts_->writer = std::thread([parts = parts_.get()] { parts->work(); });
}

RunHistory::~RunHistory() {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->ending = true;
  }
  parts_->changed.notify_all();
  parts_->writer.join();
}

std::uint64_t RunHistory::begin(RunRecord run, std::optional<std::string> text) {
  {
    const std::lock_guard lock(parts_->mutex);
    run.run = parts_->next_run++;
  }
  const std::uint64_t number = run.run;
  parts_->note(
      [database = static_cast<sqlite3*>(parts_->database), run = std::move(run), text = std::move(text)] {
        Query(database,
              "INSERT INTO runs (run, kind, name, begun_ms, begin_ns, by, state, reason, steps, text) "
              "VALUES (?, ?, ?, ?, ?, ?, 'running', '', 0, ?)")
            .put(1, static_cast<std::int64_t>(run.run))
            .put(2, std::int64_t{run.kind == RunRecord::Kind::skill ? 0 : 1})
            .put(3, run.name)
            .put(4, milliseconds(run.begun))
            .put(5, run.begin.count())
            .put(6, run.by)
            .put(7, text)
            .run();
      });
  return number;
}

void RunHistory::step(std::uint64_t run, const operations::Step& step,
                      std::vector<operations::Parameter> all) {
  parts_->note([database = static_cast<sqlite3*>(parts_->database), run, step, all = std::move(all)] {
    const auto number = static_cast<std::int64_t>(step.number), key = static_cast<std::int64_t>(run);
    Query(database, "INSERT OR REPLACE INTO steps VALUES (?, ?, ?, ?)")
        .put(1, key)
        .put(2, number)
        .put(3, operations::log_line(step))
        .put(4, json_of_parameters(all))
        .run();
    Query(database, "UPDATE runs SET steps = steps + 1 WHERE run = ?").put(1, key).run();
  });
}

void RunHistory::change(std::uint64_t run, std::string state, std::optional<Duration> end,
                        std::optional<int> code, std::string reason) {
  std::optional<std::int64_t> ended_ms, end_ns, code_now;
  if (end) {
    ended_ms = milliseconds(std::chrono::system_clock::now());
    end_ns = end->count();
  }
  if (code) code_now = *code;
  parts_->note([database = static_cast<sqlite3*>(parts_->database), run, state = std::move(state), ended_ms,
                end_ns, code_now, reason = std::move(reason)] {
    Query(database, "UPDATE runs SET state = ?, ended_ms = ?, end_ns = ?, code = ?, reason = ? WHERE run = ?")
        .put(1, state)
        .put(2, ended_ms)
        .put(3, end_ns)
        .put(4, code_now)
        .put(5, reason)
        .put(6, static_cast<std::int64_t>(run))
        .run();
  });
}

void RunHistory::make_room() {
  std::unique_lock lock(parts_->mutex);
  parts_->written.wait_for(lock, std::chrono::seconds(1),
                           [this] { return parts_->waiting.size() < most_notes_waiting; });
}

RunPage RunHistory::list(std::optional<std::uint64_t> before, std::size_t limit,
                         const std::string& name) const {
  parts_->wait_until_written();
  const std::lock_guard lock(parts_->on_database);
  if (parts_->problem) throw StoreProblem{*parts_->problem};
  RunPage page;
  const std::string text = fmt::format("SELECT {} FROM runs WHERE run < ?1{} ORDER BY run DESC LIMIT ?2",
                                       run_columns, name.empty() ? "" : " AND name = ?3");
  Query query(parts_->database, text.c_str());
  query.put(1, before ? static_cast<std::int64_t>(*before) : std::numeric_limits<std::int64_t>::max());
  query.put(2, static_cast<std::int64_t>(limit) + 1);
  if (!name.empty()) query.put(3, name);
  while (query.next()) page.runs.push_back(record_of(query));
  page.more = page.runs.size() > limit;
  if (page.more) page.runs.pop_back();
  return page;
}

RunSteps RunHistory::read(std::uint64_t run, std::uint64_t after, std::size_t limit) const {
  parts_->wait_until_written();
  const std::lock_guard lock(parts_->on_database);
  if (parts_->problem) throw StoreProblem{*parts_->problem};
  RunSteps result;
  const std::string text = fmt::format("SELECT {}, text FROM runs WHERE run = ?", run_columns);
  Query found(parts_->database, text.c_str());
  if (!found.put(1, static_cast<std::int64_t>(run)).next())
    refuse(Refusal::Why::absent, fmt::format("there is no run {}", run),
           "history.list tells those that are kept");
  result.run = record_of(found);
  constexpr int text_column = 12;
  if (!found.empty(text_column)) result.text = found.text(text_column);
  Query steps(parts_->database,
              "SELECT step, parameters FROM steps WHERE run = ? AND number > ? ORDER BY number LIMIT ?");
  steps.put(1, static_cast<std::int64_t>(run))
      .put(2, static_cast<std::int64_t>(after))
      .put(3, static_cast<std::int64_t>(limit) + 1);
  while (steps.next()) result.steps.push_back({steps.text(0), steps.text(1)});
  result.more = result.steps.size() > limit;
  if (result.more) result.steps.pop_back();
  return result;
}

StepPage RunHistory::steps_of(const std::string& skill, std::optional<std::uint64_t> before,
                              std::size_t limit) const {
  parts_->wait_until_written();
  const std::lock_guard lock(parts_->on_database);
  if (parts_->problem) throw StoreProblem{*parts_->problem};
  StepPage page;
  Query query(
      parts_->database,
      "SELECT s.run, r.name, r.begun_ms, s.step, s.parameters FROM steps s JOIN runs r ON r.run = s.run "
      "WHERE json_extract(s.step, '$.skill') = ?1 AND s.run < ?2 ORDER BY s.run DESC, s.number DESC "
      "LIMIT ?3");
  query.put(1, skill);
  query.put(2, before ? static_cast<std::int64_t>(*before) : std::numeric_limits<std::int64_t>::max());
  query.put(3, static_cast<std::int64_t>(limit) + 1);
  while (query.next())
    page.steps.push_back({static_cast<std::uint64_t>(query.number(0)),
                          query.text(1),
                          WallTime(std::chrono::milliseconds(query.number(2))),
                          {query.text(3), query.text(4)}});
  page.more = page.steps.size() > limit;
  if (page.more) page.steps.pop_back();
  return page;
}

}  // namespace pal::server
