#include "runtime/drivers/pendant/driver.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime::drivers {
namespace {

constexpr Time look_each = std::chrono::milliseconds(4);
constexpr Time least_distance = std::chrono::milliseconds(20);

}  // namespace

PendantDriver::PendantDriver()
    : ports_{{"order",
              false,
              {{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}, {"e", ""}, {"f", ""}, {"held", ""}}}} {}

void PendantDriver::order(const PendantOrder& order) {
  const std::lock_guard lock(mutex_);
  // A release is never passed over by an order that was sent after it in haste.
  if (newest_ && !newest_->held) return;
  newest_ = order;
}

std::optional<PendantOrder> PendantDriver::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(newest_, std::nullopt);
}

void PendantDriver::attach(DeviceHost& host) {
  host_ = &host;
  earliest_ = {};
}

void PendantDriver::open() {
  take();
  look();
}

void PendantDriver::receive(std::size_t, std::span<const double>) {}

void PendantDriver::look() {
  if (host_->now() >= earliest_) {
    if (const auto order = take()) {
      std::array<double, 7> fields{};
      std::copy(order->axes.begin(), order->axes.end(), fields.begin());
      fields.back() = order->held ? 1 : 0;
      earliest_ = host_->now() + least_distance;
      host_->deliver(0, fields);
    }
  }
  next_look_ = host_->at(host_->now() + look_each, [this] { look(); });
}

void PendantDriver::close() {
  if (host_ != nullptr) host_->cancel(next_look_);
  host_ = nullptr;
}

}  // namespace pal::runtime::drivers
