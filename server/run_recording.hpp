// The channels of the last runs, on the disk, so that a run can be looked at again.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "server/telemetry.hpp"

namespace pal::server {

struct RecordingLimits {
  std::size_t most_runs = 200;
  std::uint64_t most_bytes = std::uint64_t{256} << 20;  // of the database; the oldest runs go first
};

struct RecordedRun {
  std::uint64_t run = 0;    // of the history
  Duration begin{}, end{};  // of the cell: the first and the last instant that is kept
  std::vector<std::string> channels;
};

/// Instants of one channel. Each has rows of as many numbers as the channel has fields:
/// - of a channel of numbers three: least, greatest and last of a span that ends then;
/// - of a profile one for each point;
/// - of a channel of rows one for each body or contact.
struct RecordedPage {
  std::vector<Duration> times;
  std::vector<std::uint32_t> rows;  // of each instant
  std::vector<float> numbers;
  bool more = false;  // there are later ones
};

/// For all threads. What comes is written by a thread of its own, so that neither the cell nor clients wait
/// for the disk.
class RunRecording {
 public:
  /// Spans of channels of numbers are so long.
  static constexpr Duration span = std::chrono::milliseconds(20);

  /// The database is FILE; empty: a file of its own that ends with this. `channels` outlive it. Throws
  /// StoreProblem.
  RunRecording(const std::string& file, const Channels& channels, RecordingLimits limits = {});
  /// All that came is on the disk before it returns.
  ~RunRecording();
  RunRecording(const RunRecording&) = delete;
  RunRecording& operator=(const RunRecording&) = delete;

  /// What is seen from `at` on is of this run; of one that goes on, too.
  void begin(std::uint64_t run, Duration at);
  /// What is seen later is of no run.
  void end(Duration at);
  /// Whether it wants what is seen now.
  bool records() const noexcept;

  void take(std::shared_ptr<const SampleBlock> block);
  void take(std::vector<std::shared_ptr<const Rows>> rows);
  void take(Duration time, const Profile& profile);

  /// The newest first. Throws StoreProblem.
  std::vector<RecordedRun> list() const;
  /// The instants of the channel after `after`, at most so many. Empty: the run has none. Throws
  /// StoreProblem.
  RecordedPage read(std::uint64_t run, const std::string& channel, Duration after, std::size_t limit) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::server
