#include "runtime/drivers/apart.hpp"

#include <algorithm>
#include <utility>

#include "runtime/kernel/thrown.hpp"

namespace pal::runtime::drivers {

Letters::Letter& Letters::next() {
  if (count_ == ring_.size()) {
    std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(first_), ring_.end());
    first_ = 0;
    ring_.resize(2 * ring_.size());
  }
  return ring_[(first_ + count_++) % ring_.size()];
}

void Letters::send(std::unique_lock<std::mutex> lock) {
  lock.unlock();
  wake_();
}

void Letters::open(DeviceApart& device, Time when) {
  std::unique_lock lock(mutex_);
  Letter& letter = next();
  letter.kind = Letter::Kind::open;
  letter.when = when;
  letter.device = &device;
  send(std::move(lock));
}

void Letters::message(DeviceApart& device, Time when, std::size_t port, std::uint64_t request,
                      std::span<const double> fields) {
  std::unique_lock lock(mutex_);
  Letter& letter = next();
  letter.kind = Letter::Kind::message;
  letter.when = when;
  letter.device = &device;
  letter.port = port;
  letter.request = request;
  letter.fields.assign(fields.begin(), fields.end());
  send(std::move(lock));
}

void Letters::action(DeviceApart& device, std::function<void()> action) {
  std::unique_lock lock(mutex_);
  Letter& letter = next();
  letter.kind = Letter::Kind::action;
  letter.when = Time::zero();
  letter.device = &device;
  letter.action = std::move(action);
  send(std::move(lock));
}

bool Letters::withdraw(const DeviceApart& device, std::size_t port) {
  const std::unique_lock lock(mutex_);
  for (std::size_t i = count_; i > 0; --i) {
    Letter& letter = ring_[(first_ + i - 1) % ring_.size()];
    if (letter.kind != Letter::Kind::message || letter.device != &device || letter.port != port) continue;
    letter.kind = Letter::Kind::withdrawn;
    return true;
  }
  return false;
}

bool Letters::read(Time when, Letter& letter) {
  const std::unique_lock lock(mutex_);
  if (count_ == 0 || ring_[first_].when > when) return false;
  std::swap(letter, ring_[first_]);
  first_ = (first_ + 1) % ring_.size();
  --count_;
  return true;
}

bool Letters::empty() const {
  const std::unique_lock lock(mutex_);
  return count_ == 0;
}

void DeviceApart::attach(DeviceHost& host) {
  run_ = &host;
  attaching_ = true;
  device_.attach(*this);
  attaching_ = false;
}

void DeviceApart::act(const std::function<void()>& action) {
  try {
    action();
  } catch (...) {
    fault(what_was_thrown());
  }
}

void DeviceApart::take(const Letters::Letter& letter) {
  switch (letter.kind) {
    case Letters::Letter::Kind::open:
      return act([this] { device_.open(); });
    case Letters::Letter::Kind::message:
      request_ = letter.request;
      act([this, &letter] { device_.receive(letter.port, letter.fields); });
      request_ = 0;
      return;
    case Letters::Letter::Kind::action:
      return act(letter.action);
    case Letters::Letter::Kind::withdrawn:
      return;
  }
}

DeviceHost::Appointment DeviceApart::at(Time when, std::function<void()> action) {
  const Timeline::Token token =
      timeline_.at(begun_ + when, [this, alive = alive_, action = std::move(action)] {
        if (*alive) act(action);
      });
  return {token.slot, token.generation};
}

void DeviceApart::cancel(Appointment appointment) {
  timeline_.cancel({appointment.slot, static_cast<std::uint32_t>(appointment.order)});
}

/// A device that is being attached is in the kernel already.
void DeviceApart::call(const std::function<void()>& function) {
  if (attaching_) {
    function();
  } else {
    run_->post([&function] { function(); });
  }
}

bool DeviceApart::deliver(std::size_t port, std::span<const double> fields) {
  return answer(0, port, fields);
}

bool DeviceApart::answer(Request request, std::size_t port, std::span<const double> fields) {
  struct Delivery {
    DeviceHost& run;
    Request request;
    std::size_t port;
    std::span<const double> fields;
    bool taken;
  } delivery{*run_, request, port, fields, true};
  call([&delivery] {
    delivery.taken = delivery.run.answer(delivery.request, delivery.port, delivery.fields);
  });
  return delivery.taken;
}

void DeviceApart::leave_unanswered(std::size_t port) {
  call([this, port] { run_->leave_unanswered(port); });
}

void DeviceApart::mark_busy(bool busy) {
  call([this, busy] { run_->mark_busy(busy); });
}

void DeviceApart::fault(std::string reason) {
  call([this, &reason] { run_->fault(std::move(reason)); });
}

void DeviceApart::post(std::function<void()> action) {
  letters_.action(*this, std::move(action));
}

}  // namespace pal::runtime::drivers
