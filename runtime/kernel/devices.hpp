// The devices of a run.
#pragma once

#include <atomic>
#include <deque>
#include <span>
#include <vector>

#include "runtime/kernel/device_link.hpp"
#include "runtime/kernel/promises.hpp"

namespace pal::runtime {

/// A device of the run, and which of the wiring's channels each of its ports is an end of (-1: none).
struct Connection {
  Device* device = nullptr;
  std::vector<int> channels;
};

/// Devices are named by their index. What one throws ends the skill.
class Devices {
 public:
  /// All outlive the devices; `observer` may be null. The devices have the names of the wiring.
  Devices(Executive& executive, Journal& journal, Mail& mail, Promises& promises, MessageObserver* observer,
          const Wiring& wiring, const std::vector<Connection>& connections);

  /// False: one has thrown.
  bool attach();
  void open(int device);
  /// `request`: the number of the request that it is, or 0.
  void hand_to(int device, std::size_t port, std::span<const double> fields, DeviceHost::Request request = 0);
  /// Whether the device forgets the request.
  bool withdraw_from(int device, std::size_t port);
  bool marks_itself(int device) const { return link(device).marks_itself(); }
  /// An action that the device has asked for.
  void act(int device, const std::function<void()>& action);
  /// Each that was attached, whatever comes of the others.
  void close();
  /// The device whose code is being called, as another thread sees it; empty: none.
  std::string at_work() const;

 private:
  class AtWork;

  DeviceLink& link(int device) { return links_[static_cast<std::size_t>(device)]; }
  const DeviceLink& link(int device) const { return links_[static_cast<std::size_t>(device)]; }
  void fail(int device);
  std::string name(int device) const {
    return std::string(wiring_.devices[static_cast<std::size_t>(device)]);
  }

  Journal& journal_;
  Promises& promises_;
  const Wiring& wiring_;
  std::deque<DeviceLink> links_;
  std::atomic<std::size_t> attached_ =
      0;  // close() may come from a thread that has no lock, when another hangs
  std::atomic<int> at_work_ = -1;
};

}  // namespace pal::runtime
