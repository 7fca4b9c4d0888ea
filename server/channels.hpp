// Live data of the cell: channels by name, each with a rate of its own. The cell copies numbers into blocks,
// and all else is done in the server's thread.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pal/support/time.hpp"

namespace pal::server {

struct ChannelField {
  std::string name, unit;
};

/// A parameter of a skill that is a limit on fields of a channel while the skill runs: at `factor` times its
/// value, and at the negative of that with `both`. It counts from `around` times another parameter, if given.
struct ShownLimit {
  enum class Kind { band, target, stop, error };
  struct Around {
    std::string parameter;
    double factor = 1;
  };
  std::string skill, parameter;
  std::vector<std::string> fields;
  double factor = 1;
  bool both = false;
  Kind kind = Kind::target;
  std::optional<Around> around{};
};

/// What a logical sensor sees in a profile: one point, or a line between two. mm.
struct ProfileMark {
  std::string name;
  std::vector<std::array<double, 2>> points;  // y, z
  std::optional<double> value{};              // what the sensor gives, in `unit`
  std::string unit{};
};

struct Profile;

/// One channel. A record of the cell has the raw numbers of all channels.
struct Channel {
  /// Rows: at an instant as many as there are bodies, contacts … (Rows).
  enum class Form { numbers, profile, rows };
  std::string name, description;
  std::vector<ChannelField> fields;
  double rate_hz = 0;  // its own; 0: at no fixed rate
  Form form = Form::numbers;
  /// Makes the fields of a raw record; of `numbers`. Called by the server's thread and a recording's at once.
  std::function<void(std::span<const double> raw, std::span<double> shown)> show{};
  std::vector<ShownLimit> limits{};
  /// What is seen in a profile; of `profile`. Called by the server's thread.
  std::function<std::vector<ProfileMark>(const Profile&)> marks{};
};

using Channels = std::vector<Channel>;

/// Records in a row, one after the other. The cell fills it, and nobody changes it afterwards.
struct SampleBlock {
  std::size_t width = 0;  // numbers of a record
  double pace = 0;        // seconds of the cell in one of the wall, lately; 0: not known
  std::vector<Duration> times;
  std::vector<double> raw;

  std::size_t size() const { return times.size(); }
  std::span<const double> record(std::size_t at) const { return std::span(raw).subspan(at * width, width); }
};

/// A channel of rows at an instant. The cell fills it, and nobody changes it afterwards.
struct Rows {
  std::string channel;
  Duration time{};             // of the cell
  std::vector<float> numbers;  // row after row, each with the channel's fields
};

/// A block as the channels show it. Each channel is made when it is first asked for, and once for all
/// clients.
class ShownBlock {
 public:
  /// `channels` outlives it.
  ShownBlock(const Channels& channels, std::shared_ptr<const SampleBlock> block)
      : channels_(channels), block_(std::move(block)), shown_(channels.size()) {}

  const SampleBlock& block() const { return *block_; }
  /// The channel's fields, record after record.
  std::span<const double> of(std::size_t channel) const;

 private:
  const Channels& channels_;
  std::shared_ptr<const SampleBlock> block_;
  mutable std::vector<std::optional<std::vector<double>>> shown_;
};

/// The least, the greatest and the last of each field in a span: no peak is lost.
struct SampleSpan {
  Duration begin{}, end{};  // of the first and the last sample
  std::size_t count = 0;
  std::vector<double> low, high, last;
};

/// Decimates one channel for one client.
class Decimator {
 public:
  Decimator(std::size_t fields, Duration period) : fields_(fields), period_(period) {}

  /// Takes samples, adds those spans to `whole` that are over. Spans that begin now are as long as `least`,
  /// if that is longer than the period.
  void take(std::span<const Duration> times, std::span<const double> samples, std::vector<SampleSpan>& whole,
            Duration least = {});

 private:
  std::size_t fields_;
  Duration period_;
  SampleSpan open_;
  Duration due_{};
};

/// When a block is whole: a multiple of `least` records has come, and so much time has passed on the wall, or
/// there are `most` records. So a cell that runs quickly wakes the server no more often than one at the pace
/// of the wall.
struct BlockLength {
  std::size_t least = 1, most = 1;  // a multiple of `least`
  std::chrono::steady_clock::duration wall{};
};

/// Fills blocks and hands them on. Blocks that nobody holds any more are filled again. One thread only.
class BlockWriter {
 public:
  using HandOn = std::function<void(std::shared_ptr<const SampleBlock>)>;
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  /// Records have `width` numbers each.
  BlockWriter(std::size_t width, BlockLength length, HandOn hand_on,
              Clock clock = std::chrono::steady_clock::now);

  /// Room for the next record's numbers, which the caller fills before the next call.
  std::span<double> record(Duration time);
  /// Hands on what there is.
  void flush();

 private:
  struct Pool;
  void open();
  void measure_pace();

  std::size_t width_;
  BlockLength length_;
  HandOn hand_on_;
  Clock clock_;
  std::shared_ptr<Pool> pool_;
  std::shared_ptr<SampleBlock> block_;
  std::chrono::steady_clock::time_point since_;  // the block began
  double lately_cell_s_ = 0, lately_wall_s_ = 0;
};

}  // namespace pal::server
