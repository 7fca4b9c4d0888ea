#include "runtime/drivers/wire.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pal::runtime::drivers {

Time LineSpeed::duration(std::size_t bytes) const {
  const double seconds = static_cast<double>(bytes) * bits_per_byte / baud;
  return Time(static_cast<Time::rep>(std::llround(seconds * 1e9)));
}

Wire::Wire(Timeline& timeline, LineSpeed speed, Carrier* carrier)
    : timeline_(timeline),
      speed_(speed),
      carrier_(carrier),
      a_(*this, Carrier::Direction::to_b),
      b_(*this, Carrier::Direction::to_a) {}

Wire::~Wire() {
  drop(a_);
  drop(b_);
}

void Wire::send(End& from, Bytes bytes) {
  if (broken_ || bytes.empty()) return;
  from.free_at_ = std::max(timeline_.now(), from.free_at_) + speed_.duration(bytes.size());
  from.under_way_.push_back({{bytes.begin(), bytes.end()}, {}});
  from.last_arrival_ = std::max(from.free_at_ + from.later_by_, from.last_arrival_);
  from.under_way_.back().arrival = timeline_.at(from.last_arrival_, [this, &from] { arrive(from); });
}

void Wire::delay(Carrier::Direction direction, Time by) {
  (direction == Carrier::Direction::to_b ? a_ : b_).later_by_ = by;
}

void Wire::arrive(End& from) {
  std::vector<std::uint8_t> bytes = std::move(from.under_way_.front().bytes);
  from.under_way_.pop_front();
  if (tamper_) tamper_(from.direction_, bytes);
  if (carrier_ != nullptr && !bytes.empty()) bytes = carrier_->carry(from.direction_, bytes);
  LinkUser* receiver = (&from == &a_ ? b_ : a_).user();
  if (receiver != nullptr && !bytes.empty()) receiver->on_bytes(bytes);
}

void Wire::drop(End& from) {
  for (const End::Parcel& parcel : from.under_way_) timeline_.cancel(parcel.arrival);
  from.under_way_.clear();
}

void Wire::cut(std::string_view reason) {
  if (std::exchange(broken_, true)) return;
  drop(a_);
  drop(b_);
  for (const End* end : {&a_, &b_}) {
    if (end->user() != nullptr) end->user()->on_break(reason);
  }
}

}  // namespace pal::runtime::drivers
