#include "pal/trace/loss_meter.hpp"

#include <algorithm>

#include "trace/requests.hpp"

namespace pal::trace {

LossMeter::LossMeter(const Trace& tables, std::int32_t device, Of of, int in, std::int64_t period_ns)
    : device_(device),
      of_(of),
      in_(std::max(in, 1)),
      period_(period_ns),
      request_(requests_of(tables)),
      asked_(tables.channels.size()),
      number_(tables.channels.size(), -1),
      lost_(2 * static_cast<std::size_t>(in_) - 1) {
  const std::string& name = tables.actors[static_cast<std::size_t>(device)].name;
  for (const Channel& channel : tables.channels) own_.push_back(channel.sender == name);
}

std::optional<int> LossMeter::see(const Event& event) {
  Most most;
  if (open_at_ >= 0 && (event.time_ns > open_at_ || event.actor != device_)) close(most);
  if (event.actor == device_) {
    device(event, most);
    return most;
  }
  if (event.kind != Kind::drop || event.actor >= 0 || event.subject < 0) return most;
  // A message is withdrawn from its slot.
  std::int64_t& number = number_[static_cast<std::size_t>(event.subject)];
  if (number >= first_ && count_ - number <= static_cast<std::int64_t>(lost_.size())) lose(number, most);
  number = -1;
  return most;
}

std::optional<int> LossMeter::finish() {
  Most most;
  settle(most);
  return most;
}

void LossMeter::settle(Most& most) {
  if (open_at_ >= 0) close(most);
  if (begun_ && answered_) occurrence(true, most);
  begun_ = false;
}

void LossMeter::begin_phase() {
  Most before;
  settle(before);
  counts_ = true;
}

std::optional<int> LossMeter::end_phase() {
  Most most;
  settle(most);
  counts_ = false;
  first_ = count_;
  std::fill(number_.begin(), number_.end(), -1);
  return most;
}

void LossMeter::device(const Event& event, Most& most) {
  const auto subject = static_cast<std::size_t>(event.subject);
  // A frame that begins takes its requests at once.
  if (begun_ && event.kind != Kind::take) {
    if (answered_) occurrence(true, most);
    begun_ = false;
  }
  switch (event.kind) {
    case Kind::busy:
      marks_ = true;
      begun_ = of_ == Of::frames;
      break;
    case Kind::take:
      begun_ = false;
      ++asked_[subject];
      break;
    case Kind::put:
    case Kind::overrun:
      if (own_[subject]) sent(event, most);
      break;
    case Kind::drop:
      if (!own_[subject] || event.value == unasked) break;
      if (event.value != no_answer) {
        sent(event, most);
      } else if (request_[subject] >= 0 && asked_[static_cast<std::size_t>(request_[subject])] > 0) {
        --asked_[static_cast<std::size_t>(request_[subject])];
      }
      break;
    default:
      break;
  }
}

void LossMeter::sent(const Event& event, Most& most) {
  const auto subject = static_cast<std::size_t>(event.subject);
  const std::int32_t request = request_[subject];
  const bool put = event.kind == Kind::put;
  if ((request >= 0) != (of_ != Of::events)) return;
  if (request >= 0) {
    int& asked = asked_[static_cast<std::size_t>(request)];
    if (asked == 0) return;  // nobody has asked for it
    --asked;
  }
  if (of_ != Of::frames) {
    if (put) number_[subject] = counts_ ? count_ : -1;
    occurrence(!put, most);
    return;
  }
  if (open_at_ < 0) {
    if (!marks_ && answered_ && period_ > 0)
      for (std::int64_t missing = (event.time_ns - last_at_ + period_ / 2) / period_ - 1; missing > 0;
           --missing)
        occurrence(true, most);
    open_at_ = event.time_ns;
    any_put_ = false;
  }
  any_put_ = any_put_ || put;
  if (put) number_[subject] = counts_ ? count_ : -1;
  const bool all = std::all_of(asked_.begin(), asked_.end(), [](int asked) { return asked == 0; });
  if (all && marks_) close(most);
}

/// All answers of the frame have come.
void LossMeter::close(Most& most) {
  last_at_ = open_at_;
  open_at_ = -1;
  answered_ = true;
  occurrence(!any_put_, most);
}

void LossMeter::occurrence(bool lost, Most& most) {
  if (!counts_) return;
  lost_[static_cast<std::size_t>(count_) % lost_.size()] = false;
  ++count_;
  if (lost) {
    lose(count_ - 1, most);
  } else {
    most = std::max(most.value_or(0), 0);
  }
}

/// The rows with this one.
void LossMeter::lose(std::int64_t number, Most& most) {
  if (is_lost(number)) return;
  lost_[static_cast<std::size_t>(number) % lost_.size()] = true;
  const std::int64_t oldest =
      std::max({first_, number - in_ + 1, count_ - static_cast<std::int64_t>(lost_.size())});
  for (std::int64_t from = oldest; from <= number; ++from) {
    int lost = 0;
    for (std::int64_t i = from; i < std::min(from + in_, count_); ++i) lost += is_lost(i) ? 1 : 0;
    most = std::max(most.value_or(0), lost);
  }
}

}  // namespace pal::trace
