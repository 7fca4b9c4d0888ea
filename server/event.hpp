// Events of the cell, for all observers. None is ever left out.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "operations/executor.hpp"
#include "pal/support/time.hpp"
#include "server/command.hpp"
#include "server/role.hpp"

namespace pal::server {

using WallTime = std::chrono::system_clock::time_point;

/// Since 1970, as files keep it.
inline std::int64_t milliseconds(WallTime time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

/// A client that is here.
struct Present {
  ClientId client = 0;
  std::string name;
  Role role = Role::viewer;
  bool controls = false;
  WallTime since{};
};
struct Hold {
  std::string by;
  ClientId client = 0;
  Role role = Role::viewer;
  std::string reason;
  WallTime since{};
};
/// A question that waits for an answer.
struct OpenQuestion {
  operations::Question question;
  Duration since{};
  WallTime since_wall{};
};

/// The client that has the controls now; empty: none.
struct ControlsChanged {
  std::string holder;
  std::optional<ClientId> client{};
  std::string reason{};
};
struct ControlsAsked {
  ClientId client = 0;
  std::string name, reason;
};
struct ClientsChanged {
  std::vector<Present> clients;
};
/// `hold`: nothing, it was released.
struct HoldChanged {
  std::optional<Hold> hold;
  std::string by;
};
struct OperationLoaded {
  std::string name;
  std::string by{};
};
/// Of the operation.
struct StateChanged {
  operations::ExecutionState state = operations::ExecutionState::ready;
  std::string token, reason;
  int last_code = 0;
  std::size_t steps = 0;
};
/// A pause or a stop was asked for, and comes.
struct HaltAsked {
  bool pausing = false, stopping = false;
  std::string by;
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
struct ParameterSet {
  std::string icon, parameter;
  operations::Value value;
  std::optional<operations::Value> before;
  std::string by;
};
/// All that there are now.
struct BreakpointsChanged {
  std::vector<operations::Breakpoint> breakpoints;
  std::string by;
};
struct QuestionAsked {
  OpenQuestion question;
};
/// It waits no more. Without an answer it was withdrawn.
struct QuestionClosed {
  std::string icon;
  std::optional<std::string> answer;
  std::string by;
};
/// The store has changed.
struct StoreChanged {
  enum class Change { saved, renamed, deleted };
  std::string name;
  Change change = Change::saved;
  std::uint64_t version = 0;
  std::string to;  // of renamed
  std::string by;
};
struct LocationChanged {
  enum class Change { taught, renamed, deleted };
  std::string location;
  Change change = Change::taught;
  std::uint64_t version = 0;
  std::string to;  // of renamed
  std::string by;
};
/// Nothing follows.
struct ServerEnds {
  std::string reason;
};

struct Event {
  std::uint64_t number = 0;  // from 1, without a gap
  Duration time{};           // of the cell
  std::variant<ControlsChanged, ControlsAsked, ClientsChanged, HoldChanged, OperationLoaded, StateChanged,
               HaltAsked, IconReached, StepBegins, StepEnds, ParameterSet, BreakpointsChanged, QuestionAsked,
               QuestionClosed, StoreChanged, LocationChanged, ServerEnds>
      what;
  WallTime wall{};
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
