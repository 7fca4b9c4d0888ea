// The present state of a cell and its operation: in short, and whole.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "operations/executor.hpp"
#include "server/command.hpp"
#include "server/event.hpp"

namespace pal::server {

/// service: a sensor is read, or a location is taught.
enum class Activity { idle, skill, operation, service };
const char* name(Activity activity);

/// The step that goes on.
struct Running {
  operations::Step step;
  WallTime begin{};
  bool alone = false;  // it is no step of an operation
};

struct Status {
  std::string cell;
  Activity activity = Activity::idle;
  std::string operation;  // its name; empty: none is loaded
  operations::ExecutionState state = operations::ExecutionState::ready;
  std::string token, reason;
  int last_code = 0;
  std::size_t steps = 0;
  std::string holder;  // of the controls; empty: none
  bool yours = false;
  std::uint64_t last_event = 0;
  Duration time{};  // of the cell
  std::string epoch;
  WallTime wall{};
  bool pausing = false, stopping = false;  // asked for, and not there yet
  std::optional<Running> running{};
  std::optional<Hold> hold{};
  std::optional<OpenQuestion> question{};
  std::uint64_t run = 0;  // of the history: what runs, or ran last; 0: nothing yet
};

/// What an icon has been through since the operation began.
struct IconState {
  std::size_t visits = 0, ends = 0;  // arrivals of the token; normal ends
  std::optional<int> code{};         // the last one
  operations::SkillResult::Kind kind = operations::SkillResult::Kind::normal;
  Duration last{};     // when the token came
  std::string reason;  // why it ended so; empty: it has not ended since
  std::optional<Duration> took{};
};

/// A parameter that is not as the file has it.
struct ChangedParameter {
  operations::Value value;
  std::optional<operations::Value> before;  // as the file has it; nothing: it does not
  std::string by;
};

struct LoadedFiles {
  std::map<std::string, std::string> files;
  std::string main;
  std::optional<StoredVersion> stored;
};

struct LastReading {
  double value = 0;
  Duration time{};
};

struct Here {
  std::string icon;
  Duration since{};
  WallTime since_wall{};
};

struct Snapshot {
  Status status;
  ClientId client = 0;
  Role role = Role::viewer;
  std::shared_ptr<const LoadedFiles> loaded;  // null: none
  /// By icon and parameter.
  std::map<std::pair<std::string, std::string>, ChangedParameter> changed;
  std::vector<operations::Breakpoint> breakpoints;
  std::map<std::string, IconState> icons;
  std::optional<Here> here;
  std::vector<Present> clients;
  std::vector<ControlsAsked> asking;
};

}  // namespace pal::server
