// Events of the cell, for all observers. None is ever left out.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "operations/executor.hpp"
#include "pal/support/time.hpp"

namespace pal::server {

/// The client that has the controls now; empty: none.
struct ControlsChanged {
  std::string holder;
};
struct OperationLoaded {
  std::string name;
};
/// Of the operation; of a skill that runs alone `alone` is set and the state is running or ended.
struct StateChanged {
  operations::ExecutionState state = operations::ExecutionState::ready;
  std::string token, reason;
  int last_code = 0;
  std::size_t steps = 0;
  bool alone = false;
};
/// The token has come to an icon.
struct IconReached {
  std::string icon;
};
/// A skill or a delay; without an icon it runs alone.
struct StepBegins {
  operations::Step step;
};
struct StepEnds {
  operations::Step step;
};

struct Event {
  std::uint64_t number = 0;  // from 1, without a gap
  Duration time{};           // of the cell
  std::variant<ControlsChanged, OperationLoaded, StateChanged, IconReached, StepBegins, StepEnds> what;
};

/// Gets the events in the order of their numbers, from one thread at a time. Must not throw, nor call the
/// desk.
class EventSink {
 public:
  virtual ~EventSink() = default;
  virtual void happened(const Event& event) = 0;
  /// Called by the cell's thread before each icon, with no lock held. It may wait until what has happened is
  /// on its way. An operation in which no time passes can be faster than the sink.
  virtual void make_room() {}
};

}  // namespace pal::server
