#include "server/run_recording.hpp"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "server/database.hpp"

namespace pal::server {
namespace {

constexpr int recording_format = 1;
// A channel's instants are written together when they last so long, or are so many numbers.
constexpr Duration chunk_time = std::chrono::seconds(2);
constexpr std::size_t chunk_numbers = 100'000;
// What may wait for the writer, in bytes: minutes of all channels. More than that is left out.
constexpr std::size_t most_bytes_waiting = std::size_t{32} << 20;
// Who asks for a recording waits so long for the writer.
constexpr std::chrono::seconds longest_wait(20);

/// Instants of a channel that are written as one.
struct Chunk {
  std::vector<std::int64_t> times;  // ns
  std::vector<std::uint32_t> rows;
  std::vector<float> numbers;

  void add(Duration time, std::size_t count, const std::vector<float>& more) {
    times.push_back(time.count());
    rows.push_back(static_cast<std::uint32_t>(count));
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
};

template <class Number>
void put_all(std::string& bytes, const std::vector<Number>& numbers) {
  const std::size_t at = bytes.size();
  bytes.resize(at + numbers.size() * sizeof(Number));
  std::memcpy(bytes.data() + at, numbers.data(), numbers.size() * sizeof(Number));
}

template <class Number>
bool take_all(const std::string& bytes, std::size_t& at, std::vector<Number>& numbers, std::size_t count) {
  if (count > (bytes.size() - at) / sizeof(Number)) return false;
  numbers.resize(count);
  std::memcpy(numbers.data(), bytes.data() + at, count * sizeof(Number));
  at += count * sizeof(Number);
  return true;
}

std::string packed_chunk(const Chunk& chunk) {
  std::string plain;
  put_all(plain, chunk.times);
  put_all(plain, chunk.rows);
  put_all(plain, chunk.numbers);
  uLongf size = compressBound(plain.size());
  std::string result(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
                plain.size(), Z_BEST_SPEED) != Z_OK)
    refuse(Refusal::Why::failed, "a recording cannot be packed", "look at the memory of the cell's computer");
  result.resize(size);
  return result;
}

Chunk unpacked(const std::string& bytes, std::size_t instants, std::size_t plain_size) {
  std::string plain(plain_size, '\0');
  uLongf size = plain_size;
  Chunk chunk;
  std::size_t at = 0;
  const bool whole = uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == Z_OK &&
                     size == plain_size && take_all(plain, at, chunk.times, instants) &&
                     take_all(plain, at, chunk.rows, instants) &&
                     take_all(plain, at, chunk.numbers, (plain_size - at) / sizeof(float));
  if (!whole)
    refuse(Refusal::Why::failed, "a recording is damaged", "look at the disk of the cell's computer");
  return chunk;
}

std::size_t size_of(const Chunk& chunk) {
  return chunk.times.size() * (sizeof(std::int64_t) + sizeof(std::uint32_t)) +
         chunk.numbers.size() * sizeof(float);
}

}  // namespace

struct RunRecording::Parts {
  Parts(const std::string& file, const Channels& the_channels, RecordingLimits the_limits)
      : channels(the_channels), limits(the_limits), database(file) {
    try {
      prepare();
    } catch (const StoreProblem& failed) {
      refuse(Refusal::Why::failed, fmt::format("{}: {}", file, failed.refusal.message),
             "move the file away, and a new recording begins");
    }
  }

  void prepare() {
    execute(database, "PRAGMA auto_vacuum=INCREMENTAL; PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;");
    if (pragma(database, "PRAGMA user_version") > recording_format)
      refuse(Refusal::Why::failed, "it was written by a newer program");
    execute(database,
            "CREATE TABLE IF NOT EXISTS chunks (run INTEGER, channel TEXT, begin_ns INTEGER, end_ns INTEGER, "
            "instants INTEGER, plain INTEGER, bytes BLOB);"
            "CREATE INDEX IF NOT EXISTS chunks_by_time ON chunks (run, channel, end_ns);");
    execute(database, fmt::format("PRAGMA user_version={}", recording_format).c_str());
  }

  /// In any thread. The work keeps so many bytes; one that keeps none is never left out. Gives its number.
  std::uint64_t note(std::function<void()> work, std::size_t bytes) {
    std::uint64_t number = 0;
    {
      const std::lock_guard lock(mutex);
      if (bytes > 0 && waiting_bytes + bytes > most_bytes_waiting) return noted;
      waiting.push_back(std::move(work));
      waiting_bytes += bytes;
      number = ++noted;
    }
    changed.notify_all();
    return number;
  }
  /// What came before is in the database.
  void write_all() {
    const std::uint64_t mine = note([this] { write_open(); }, 0);
    std::unique_lock lock(mutex);
    if (!written.wait_for(lock, longest_wait, [this, mine] { return done >= mine; }))
      refuse(Refusal::Why::failed, "the recording is not on the disk yet",
             "ask again; the cell's computer is busy");
  }

  // In the writer's thread.
  void work() {
    for (;;) {
      std::deque<std::function<void()>> taken;
      {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return ending || !waiting.empty(); });
        if (waiting.empty()) break;
        taken.swap(waiting);
        waiting_bytes = 0;
      }
      for (const auto& each : taken) each();
      {
        const std::lock_guard lock(mutex);
        done += taken.size();
      }
      written.notify_all();
    }
    write_open();
  }
  void begin(std::uint64_t number, Duration at) {
    write_open();
    decimators.clear();
    run = number;
    from = at;
    to = Duration::max();
  }
  bool within(Duration time) const { return run != 0 && time >= from && time <= to; }
  void add(const std::string& channel, Duration time, std::size_t rows, const std::vector<float>& numbers) {
    Chunk& chunk = open[channel];
    // Time that was there already: what comes late is of no use.
    if (!chunk.times.empty() && time.count() <= chunk.times.back()) return;
    chunk.add(time, rows, numbers);
    if (chunk.numbers.size() < chunk_numbers && time.count() - chunk.times.front() < chunk_time.count())
      return;
    guarded([&] {
      write(channel, chunk);
      keep_limits();
    });
    chunk = {};
  }
  void add(const SampleBlock& block) {
    // A cell whose block lasts over the run's end shows the part that is within.
    const ShownBlock shown(channels, std::shared_ptr<const SampleBlock>(&block, [](const SampleBlock*) {}));
    std::size_t first = 0, last = block.size();
    while (first < last && !within(block.times[first])) ++first;
    while (last > first && !within(block.times[last - 1])) --last;
    if (first == last) return;
    for (std::size_t at = 0; at < channels.size(); ++at) {
      const Channel& channel = channels[at];
      if (channel.form != Channel::Form::numbers) continue;
      const std::size_t fields = channel.fields.size();
      auto& decimator = decimators.try_emplace(at, fields, span).first->second;
      spans.clear();
      decimator.take(std::span(block.times).subspan(first, last - first),
                     shown.of(at).subspan(first * fields, (last - first) * fields), spans);
      for (const SampleSpan& each : spans) {
        std::vector<float> numbers;
        for (const auto* part : {&each.low, &each.high, &each.last})
          for (const double value : *part) numbers.push_back(static_cast<float>(value));
        add(channel.name, each.end, 3, numbers);
      }
    }
  }
  void add(const Rows& rows) {
    if (!within(rows.time)) return;
    for (const Channel& channel : channels)
      if (channel.name == rows.channel && channel.form == Channel::Form::rows)
        add(channel.name, rows.time, rows.numbers.size() / channel.fields.size(), rows.numbers);
  }
  void add(Duration time, const Profile& profile) {
    if (!within(time)) return;
    std::vector<float> numbers;
    for (std::size_t i = 0; i < profile.y.size(); ++i) {
      numbers.push_back(static_cast<float>(profile.y[i]));
      numbers.push_back(static_cast<float>(profile.z[i]));
    }
    for (const Channel& channel : channels)
      if (channel.form == Channel::Form::profile) add(channel.name, time, profile.y.size(), numbers);
  }
  void write_open() {
    guarded([this] {
      for (auto& [channel, chunk] : open) write(channel, chunk);
      keep_limits();
    });
    open.clear();
  }
  void write(const std::string& channel, const Chunk& chunk) {
    if (chunk.times.empty()) return;
    Query(database, "INSERT INTO chunks VALUES (?, ?, ?, ?, ?, ?, ?)")
        .put(1, static_cast<std::int64_t>(run))
        .put(2, channel)
        .put(3, chunk.times.front())
        .put(4, chunk.times.back())
        .put(5, static_cast<std::int64_t>(chunk.times.size()))
        .put(6, static_cast<std::int64_t>(size_of(chunk)))
        .put_bytes(7, packed_chunk(chunk))
        .run();
  }
  template <class Write>
  void guarded(const Write& write) {
    const std::lock_guard lock(on_database);
    try {
      execute(database, "BEGIN");
      write();
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
      Query count(database, "SELECT count(DISTINCT run), min(run) FROM chunks");
      count.next();
      const std::int64_t runs = count.number(0), oldest = count.number(1);
      const bool large = bytes_of(database) > static_cast<std::int64_t>(limits.most_bytes);
      if (runs == 0 || (!large && runs <= static_cast<std::int64_t>(limits.most_runs))) return;
      if (runs > 1) {
        Query(database, "DELETE FROM chunks WHERE run = ?").put(1, oldest).run();
        continue;
      }
      // One run alone fills it: its first quarter goes.
      Query(
          database,
          "DELETE FROM chunks WHERE end_ns <= (SELECT min(begin_ns) + (max(end_ns) - min(begin_ns)) / 4 FROM "
          "chunks)")
          .run();
      return;
    }
  }

  const Channels& channels;
  const RecordingLimits limits;
  Database database;
  mutable std::mutex on_database;
  std::optional<Refusal> problem;  // of the last write

  std::mutex mutex;
  std::condition_variable changed, written;
  std::deque<std::function<void()>> waiting;
  std::size_t waiting_bytes = 0;
  std::uint64_t noted = 0, done = 0;  // works, since the beginning
  bool ending = false;
  std::atomic<bool> records = false;
  std::atomic<std::int64_t> ends_at = std::numeric_limits<std::int64_t>::max();

  // The writer's.
  std::uint64_t run = 0;
  Duration from{}, to{};
  std::map<std::string, Chunk> open;
  std::map<std::size_t, Decimator> decimators;
  std::vector<SampleSpan> spans;
  std::thread writer;
};

RunRecording::RunRecording(const std::string& file, const Channels& channels, RecordingLimits limits)
    : parts_(std::make_unique<Parts>(file, channels, limits)) {
  parts_->writer = std::thread([parts = parts_.get()] { parts->work(); });
}

RunRecording::~RunRecording() {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->ending = true;
  }
  parts_->changed.notify_all();
  parts_->writer.join();
}

void RunRecording::begin(std::uint64_t run, Duration at) {
  parts_->ends_at = std::numeric_limits<std::int64_t>::max();
  parts_->note([parts = parts_.get(), run, at] { parts->begin(run, at); }, 0);
  parts_->records = true;
}

void RunRecording::end(Duration at) {
  parts_->ends_at = at.count();
  parts_->note([parts = parts_.get(), at] { parts->to = at; }, 0);
}

bool RunRecording::records() const noexcept {
  return parts_->records.load(std::memory_order_relaxed);
}

void RunRecording::take(std::shared_ptr<const SampleBlock> block) {
  if (!records()) return;
  // The last block of a run comes after its end.
  if (block->size() > 0 && block->times.back().count() >= parts_->ends_at) parts_->records = false;
  const std::size_t bytes = (block->raw.size() + block->size()) * sizeof(double);
  parts_->note([parts = parts_.get(), block = std::move(block)] { parts->add(*block); }, bytes);
}

void RunRecording::take(std::vector<std::shared_ptr<const Rows>> rows) {
  if (!records()) return;
  std::size_t bytes = 1;
  for (const auto& each : rows) bytes += each->numbers.size() * sizeof(each->numbers.front());
  parts_->note(
      [parts = parts_.get(), rows = std::move(rows)] {
        for (const auto& each : rows) parts->add(*each);
      },
      bytes);
}

void RunRecording::take(Duration time, const Profile& profile) {
  if (!records()) return;
  const std::size_t bytes = (profile.y.size() + profile.z.size()) * sizeof(double);
  parts_->note([parts = parts_.get(), time, profile] { parts->add(time, profile); }, bytes);
}

std::vector<RecordedRun> RunRecording::list() const {
  parts_->write_all();
  const std::lock_guard lock(parts_->on_database);
  if (parts_->problem) throw StoreProblem{*parts_->problem};
  std::vector<RecordedRun> result;
  Query query(
      parts_->database,
      "SELECT run, channel, min(begin_ns), max(end_ns) FROM chunks GROUP BY run, channel ORDER BY run "
      "DESC, channel");
  while (query.next()) {
    const auto run = static_cast<std::uint64_t>(query.number(0));
    const Duration begin(query.number(2)), end(query.number(3));
    if (result.empty() || result.back().run != run) result.push_back({run, begin, end, {}});
    RecordedRun& last = result.back();
    last.begin = std::min(last.begin, begin);
    last.end = std::max(last.end, end);
    last.channels.push_back(query.text(1));
  }
  return result;
}

RecordedPage RunRecording::read(std::uint64_t run, const std::string& channel, Duration after,
                                std::size_t limit) const {
  parts_->write_all();
  const std::lock_guard lock(parts_->on_database);
  if (parts_->problem) throw StoreProblem{*parts_->problem};
  RecordedPage page;
  Query query(
      parts_->database,
      "SELECT instants, plain, bytes FROM chunks WHERE run = ? AND channel = ? AND end_ns > ? ORDER BY "
      "end_ns");
  query.put(1, static_cast<std::int64_t>(run)).put(2, channel).put(3, after.count());
  while (query.next()) {
    const Chunk chunk = unpacked(query.text(2), static_cast<std::size_t>(query.number(0)),
                                 static_cast<std::size_t>(query.number(1)));
    const std::size_t all = [&] {
      std::size_t sum = 0;
      for (const std::uint32_t each : chunk.rows) sum += each;
      return sum;
    }();
    const std::size_t fields = all == 0 ? 0 : chunk.numbers.size() / all;
    auto at = chunk.numbers.begin();
    for (std::size_t i = 0; i < chunk.times.size(); ++i) {
      const auto end = at + static_cast<std::ptrdiff_t>(chunk.rows[i] * fields);
      if (chunk.times[i] > after.count()) {
        if (page.times.size() == limit) {
          page.more = true;
          return page;
        }
        page.times.emplace_back(chunk.times[i]);
        page.rows.push_back(chunk.rows[i]);
        page.numbers.insert(page.numbers.end(), at, end);
      }
      at = end;
    }
  }
  return page;
}

}  // namespace pal::server
