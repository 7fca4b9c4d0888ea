#include "server/channels.hpp"

#include <algorithm>
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
                     std::vector<SampleSpan>& whole) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto sample = samples.subspan(i * fields_, fields_);
    if (open_.count > 0 && times[i] >= due_) whole.push_back(std::exchange(open_, {}));
    if (open_.count == 0) {
      open_.begin = times[i];
      // Spans have their places on the clock, so that those of all channels and clients agree.
      due_ = (times[i] / period_ + 1) * period_;
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

std::span<double> BlockWriter::record(Duration time) {
  if (block_ && block_->size() >= length_) flush();
  if (!block_) {
    block_ = std::make_shared<SampleBlock>();
    block_->width = width_;
    block_->times.reserve(length_);
    block_->raw.resize(width_ * length_);
  }
  block_->times.push_back(time);
  return std::span(block_->raw).subspan((block_->size() - 1) * width_, width_);
}

void BlockWriter::flush() {
  if (!block_ || block_->size() == 0) return;
  hand_on_(std::exchange(block_, nullptr));
}

}  // namespace pal::server
