// Where clients ask and the cell works: one skill or operation at a time, for the client that has the
// controls. Whether a command is allowed is decided here; where an operation goes on, by its executor.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"
#include "server/command.hpp"
#include "server/event.hpp"

namespace pal::server {

using ClientId = std::uint64_t;

enum class Activity { idle, skill, operation };
const char* name(Activity activity);

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
  Duration time{};  // of the cell, when something last happened
};

struct DeskOptions {
  std::string cell;  // what the cell is called
  /// When the client goes that has the controls: the operation pauses after its current skill, or goes on.
  bool pause_when_holder_goes = true;
  /// Sees each step of every operation, and skills that run alone; may be null.
  operations::StepObserver* log = nullptr;
  operations::Sensors sensors{};  // what tests and waits can read
  /// Those that are taught; nothing: not known.
  std::optional<std::set<std::string>> locations{};
};

/// Clients are served by any threads; the cell works in one, which calls work(). A pause or a stop that is
/// answered is obeyed: none gets lost between two skills, or while an operation begins.
class Desk final {
 public:
  /// Runner, sink and log outlive the desk. The runner belongs to the thread that calls work(), but for
  /// stop().
  Desk(operations::SkillRunner& runner, operations::Skills skills, EventSink& sink, DeskOptions options = {});
  ~Desk();
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  // For clients.
  ClientId enter(std::string name);
  /// The client has gone; what it ran pauses or goes on, as configured, and the controls are free.
  void leave(ClientId client);
  /// A command that needs the controls takes them, if they are free. Every client may pause and stop. The
  /// answer comes at once, of RunSkill when the skill has ended.
  void ask(ClientId client, Command command, Answerer answer);
  Status status(ClientId client) const;
  const operations::Skills& skills() const;
  const operations::Sensors& sensors() const;
  /// The cell stops at once, and nothing is obeyed from now on.
  void end();

  // For the cell.
  /// Does one thing that was asked for, to its end. False: nothing was asked for.
  bool work();
  /// Until something is asked for, the desk ends, or this time is over.
  void wait(std::chrono::milliseconds longest);
  bool ended() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::server
