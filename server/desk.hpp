// Where clients ask and the cell works: one skill or operation at a time, for the client that has the
// controls. Whether a command is allowed is decided here; where an operation goes on, by its executor.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"
#include "server/command.hpp"
#include "server/event.hpp"
#include "server/locations.hpp"
#include "server/outlook.hpp"
#include "server/role.hpp"
#include "server/run_history.hpp"
#include "server/run_recording.hpp"
#include "server/status.hpp"

namespace pal::server {

struct DeskOptions {
  std::string cell;  // what the cell is called
  /// When the client goes that has the controls: the operation pauses after its current skill, or goes on.
  bool pause_when_holder_goes = true;
  /// Sees each step of every operation, and skills that run alone; may be null.
  operations::StepObserver* log = nullptr;
  operations::Sensors sensors{};  // what tests and waits can read
  /// Those that are taught; nothing: not known.
  std::optional<std::set<std::string>> locations{};
  /// Where they are, and the robot that is taught; null: this cell cannot be taught. Both outlive the desk.
  Locations* book = nullptr;
  TaughtRobot* robot = nullptr;
  std::optional<operations::Sensors> figures{};  // that skills report; nothing: not known
  std::map<std::string, std::string> unable{};   // skills that the cell cannot run, and why
  operations::DeclaredTimes longest{};           // of its skills
  operations::RefusedTogether refused_together{};
  RunHistory* runs = nullptr;         // gets each execution; null: nobody does. It outlives the desk
  RunRecording* recording = nullptr;  // is told when runs of the history begin and end; likewise
  Pendant* pendant = nullptr;         // null: nobody can move the arm by hand. It outlives the desk
  /// How long the cell waits on the wall before it looks for an answer again. A cell in virtual time needs
  /// this: its own time would rush past.
  std::chrono::milliseconds answer_wait{0};
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
  ClientId enter(std::string name, Role role = Role::programmer);
  /// The client has gone; what it ran pauses or goes on, as configured, and the controls are free. A skill
  /// that it ran alone is stopped.
  void leave(ClientId client);
  /// A command that needs the controls takes them, if they are free. Every client may pause and stop. The
  /// answer comes at once, of RunSkill when the skill has ended. An operation that is to be loaded is checked
  /// first, in the calling thread, while the desk serves others; `stop` ends the check.
  void ask(ClientId client, Command command, Answerer answer, const operations::Stop& stop = {});
  Status status(ClientId client) const;
  Snapshot snapshot(ClientId client) const;
  std::vector<Present> clients() const;
  std::vector<operations::Breakpoint> breakpoints() const;
  /// What would happen first if the operation went on from `icon`; empty: from each sensible place.
  std::variant<Outlook, Refusal> outlook(const std::string& icon) const;
  /// The values with which the icon's skill runs next.
  std::variant<IconValues, Refusal> values(const std::string& icon) const;
  const operations::Skills& skills() const;
  const operations::Sensors& sensors() const;
  /// Null: this cell cannot be taught.
  const Locations* locations() const;
  /// Whether clients can move the arm by hand.
  bool can_jog() const;
  /// What sensors showed when they were last read.
  std::map<std::string, LastReading> readings() const;
  /// What operations are checked against now.
  std::shared_ptr<const operations::Cell> cell() const;
  /// New at each start: numbers of events and clients count within it.
  const std::string& epoch() const;
  /// Tells all clients something that has happened outside the desk.
  void tell(decltype(Event::what) what);
  /// The cell stops at once, and nothing is obeyed from now on.
  void end();

  // For the cell.
  /// Does one thing that was asked for, to its end. False: nothing was asked for.
  bool work();
  /// Until something is asked for, the desk ends, or this time is over.
  void wait(std::chrono::milliseconds longest);
  bool ended() const;
  /// The cell's time is this now. From any thread.
  void tell_time(Duration now) noexcept;

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::server
