#include "runtime/kernel/devices.hpp"

#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {

/// Code of the device is being called, for as long as this lives; of another one before and afterwards.
class Devices::AtWork {
 public:
  AtWork(std::atomic<int>& at_work, int device)
      : at_work_(at_work), before_(at_work.load(std::memory_order_relaxed)) {
    at_work_.store(device, std::memory_order_relaxed);
  }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
  ~AtWork() { at_work_.store(before_, std::memory_order_relaxed); }

 private:
  std::atomic<int>& at_work_;
  int before_;
};

Devices::Devices(Executive& executive, Journal& journal, Mail& mail, Promises& promises,
                 MessageObserver* observer, const Wiring& wiring, const std::vector<Connection>& connections)
    : journal_(journal), promises_(promises), wiring_(wiring) {
  for (const Connection& connection : connections) {
    const int index = static_cast<int>(links_.size());
    links_.emplace_back(executive, journal, mail, observer, index, name(index), *connection.device,
                        connection.channels);
  }
}

/// With the exception that is being handled.
void Devices::fail(int device) {
  journal_.fail_device(device, name(device) + ": " + what_was_thrown());
}

bool Devices::attach() {
  for (std::size_t d = 0; d < links_.size(); ++d) {
    const AtWork at_work(at_work_, static_cast<int>(d));
    try {
      links_[d].device().attach(links_[d]);
      attached_.store(d + 1, std::memory_order_release);
    } catch (...) {
      fail(static_cast<int>(d));
      return false;
    }
  }
  return true;
}

void Devices::open(int device) {
  promises_.opened(device);
  const AtWork at_work(at_work_, device);
  try {
    link(device).open();
  } catch (...) {
    fail(device);
  }
}

void Devices::hand_to(int device, std::size_t port, std::span<const double> fields,
                      DeviceHost::Request request) {
  if (journal_.over()) return;
  const AtWork at_work(at_work_, device);
  try {
    link(device).receive(port, fields, request);
  } catch (...) {
    fail(device);
  }
}

bool Devices::withdraw_from(int device, std::size_t port) {
  const AtWork at_work(at_work_, device);
  try {
    const bool forgets = link(device).device().withdraw(port);
    if (forgets) {
      link(device).observe_forgotten(port);
      promises_.forgotten(device, link(device).busy());
    }
    return forgets;
  } catch (...) {
    fail(device);
    return true;
  }
}

void Devices::act(int device, const std::function<void()>& action) {
  const AtWork at_work(at_work_, device);
  try {
    action();
  } catch (...) {
    fail(device);
  }
}

void Devices::close() {
  const std::size_t attached = attached_.load(std::memory_order_acquire);
  for (std::size_t d = 0; d < attached; ++d) {
    DeviceLink& each = links_[d];
    const AtWork at_work(at_work_, static_cast<int>(d));
    try {
      each.device().close();
    } catch (...) {
      journal_.fail_to_close(name(static_cast<int>(d)), what_was_thrown());
    }
  }
}

std::string Devices::at_work() const {
  const int device = at_work_.load(std::memory_order_relaxed);
  return device < 0 ? std::string() : name(device);
}

}  // namespace pal::runtime
