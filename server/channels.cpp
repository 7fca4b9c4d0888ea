#include "server/channels.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace pal::server {

std::span<const double> ShownBlock::of(std::size_t channel) const {
  std::optional<std::vector<double>>& shown = shown_[channel];
  if (!shown) {
    const Channel& made = channels_[channel];
    const std::size_t fields = made.fields.size();
    shown.emplace(fields * block_->size());
    for (std::size_t i = 0; i < block_->size(); ++i)
      made.show(block_->record(i), std::span(*shown).subspan(i * fields, fields));
  }
  return *shown;
}

void Decimator::take(std::span<const Duration> times, std::span<const double> samples,
                     std::vector<SampleSpan>& whole, Duration least) {
  const Duration period = std::max(period_, least);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto sample = samples.subspan(i * fields_, fields_);
    if (open_.count > 0 && times[i] >= due_) whole.push_back(std::exchange(open_, {}));
    if (open_.count == 0) {
      open_.begin = times[i];
      // Spans have their places on the clock, so that those of all channels and clients agree.
      due_ = (times[i] / period + 1) * period;
      open_.low.assign(sample.begin(), sample.end());
      open_.high = open_.last = open_.low;
    } else {
      for (std::size_t field = 0; field < fields_; ++field) {
        open_.low[field] = std::min(open_.low[field], sample[field]);
        open_.high[field] = std::max(open_.high[field], sample[field]);
        open_.last[field] = sample[field];
      }
    }
    open_.end = times[i];
    ++open_.count;
  }
  // The last span may be over although no later sample says so: the next one would come after it.
  if (open_.count > 0 && times.size() > 1 && times.back() + (times.back() - times[times.size() - 2]) >= due_)
    whole.push_back(std::exchange(open_, {}));
}

/// Blocks to be filled again. Readers give them back from their thread.
struct BlockWriter::Pool {
  std::mutex mutex;
  std::vector<std::unique_ptr<SampleBlock>> free;
};

BlockWriter::BlockWriter(std::size_t width, BlockLength length, HandOn hand_on, Clock clock)
    : width_(width),
      length_(length),
      hand_on_(std::move(hand_on)),
      clock_(std::move(clock)),
      pool_(std::make_shared<Pool>()) {}

std::span<double> BlockWriter::record(Duration time) {
  if (block_ && block_->size() % length_.least == 0) {
    if (block_->size() >= length_.most || clock_() - since_ >= length_.wall) flush();
  }
  if (!block_) open();
  block_->times.push_back(time);
  return std::span(block_->raw).subspan((block_->size() - 1) * width_, width_);
}

void BlockWriter::open() {
  std::unique_ptr<SampleBlock> room;
  {
    const std::lock_guard lock(pool_->mutex);
    if (!pool_->free.empty()) {
      room = std::move(pool_->free.back());
      pool_->free.pop_back();
    }
  }
  if (!room) {
    room = std::make_unique<SampleBlock>();
    room->width = width_;
    room->times.reserve(length_.most);
    room->raw.resize(width_ * length_.most);
  }
  room->times.clear();
  room->pace = 0;
  block_ = std::shared_ptr<SampleBlock>(room.release(), [pool = pool_](SampleBlock* done) {
    constexpr std::size_t most_free = 4;
    std::unique_ptr<SampleBlock> back(done);
    const std::lock_guard lock(pool->mutex);
    if (pool->free.size() < most_free) pool->free.push_back(std::move(back));
  });
  since_ = clock_();
}

/// A cell that catches up after a delay is not taken for a quick one: some blocks count together.
void BlockWriter::measure_pace() {
  constexpr double remembered = 0.8;
  const auto in_s = [](auto time) { return std::chrono::duration<double>(time).count(); };
  lately_cell_s_ = remembered * lately_cell_s_ + in_s(block_->times.back() - block_->times.front());
  lately_wall_s_ = remembered * lately_wall_s_ + in_s(clock_() - since_);
  if (lately_wall_s_ > 0) block_->pace = lately_cell_s_ / lately_wall_s_;
}

void BlockWriter::flush() {
  if (!block_ || block_->size() == 0) return;
  measure_pace();
  hand_on_(std::exchange(block_, nullptr));
}

}  // namespace pal::server
