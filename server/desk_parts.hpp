// The desk's inside: what it knows, and how it obeys each command.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "server/desk.hpp"

namespace pal::server {

/// The cell's runner, but questions are answered by clients.
class AskingRunner final : public operations::SkillRunner {
 public:
  AskingRunner(operations::SkillRunner& runner, Desk::Parts& desk) : runner_(runner), desk_(desk) {}
  std::optional<std::string> initialise() override { return runner_.initialise(); }
  operations::SkillResult run(const std::string& skill, const std::vector<operations::Parameter>& parameters,
                              std::optional<Duration> limit) override {
    return runner_.run(skill, parameters, limit);
  }
  bool delay(Duration time) override { return runner_.delay(time); }
  operations::Reading sense(const std::string& sensor) override;
  std::optional<std::string> zero(const std::string& sensor) override { return runner_.zero(sensor); }
  void ask(const operations::Question& question) override;
  operations::Reply answer() override;
  void withdraw() override;
  Duration now() const override { return runner_.now(); }
  void stop() noexcept override { runner_.stop(); }
  void allow() override { runner_.allow(); }

 private:
  operations::SkillRunner& runner_;
  Desk::Parts& desk_;
};

struct Desk::Parts final : operations::StepObserver {
  struct SkillJob {
    RunSkill command;
    ClientId client = 0;
    Answerer answer;
  };
  struct OperationJob {
    std::size_t steps = 0;  // 0: until something halts it
  };
  /// Work with the robot that is neither a skill nor an operation. The cell's thread does it, without the
  /// lock.
  struct Served {
    Reply reply;
    std::optional<decltype(Event::what)> event{};
  };
  struct ServiceJob {
    std::function<Served()> work;
    Answerer answer;
  };
  /// A command that is being obeyed. Whoever takes the answerer answers later.
  struct Asked {
    ClientId client = 0;
    Answerer answer;
    Done done{};
  };
  using Result = std::optional<Refusal>;
  struct Client {
    std::string name;
    Role role = Role::viewer;
    WallTime since{};
  };

  Parts(operations::SkillRunner& the_runner, operations::Skills the_skills, EventSink& the_sink,
        DeskOptions the_options);

  // All that follows, up to the cell's part: with the lock held.
  void publish(decltype(Event::what) what);
  void publish_state();
  void look_at_executor();
  /// A copy that does not change.
  std::shared_ptr<const operations::Cell> known_cell() const;
  Duration time_now() const { return Duration(now.load(std::memory_order_relaxed)); }
  void set_time(Duration time) { now.store(time.count(), std::memory_order_relaxed); }
  const std::string& name_of(ClientId client) const;
  std::vector<Present> present() const;

  Result need_controls(ClientId client) const;
  Result need_rest() const;
  Result need_operation() const;
  Result need_no_hold() const;
  Result need_role(const Asked& asked, const Command& command) const;
  void give_controls(std::optional<ClientId> client, const std::string& reason = {});

  Result obey(Asked& asked, TakeControls& command);
  Result obey(Asked& asked, AskForControls& command);
  Result obey(Asked& asked, GiveControls& command);
  Result obey(Asked& asked, ReleaseControls& command);
  Result obey(Asked& asked, SetHold& command);
  Result obey(Asked& asked, ReleaseHold& command);
  Result obey(Asked& asked, RunSkill& command);
  Result obey(Asked& asked, LoadOperation& command);  // see load()
  Result obey(Asked& asked, RunOperation& command);
  Result obey(Asked& asked, Pause& command);
  Result obey(Asked& asked, Stop& command);
  Result obey(Asked& asked, PutToken& command);
  Result obey(Asked& asked, SetParameter& command);
  Result obey(Asked& asked, SetBreakpoint& command);
  Result obey(Asked& asked, RemoveBreakpoint& command);
  Result obey(Asked& asked, ClearBreakpoints& command);
  Result obey(Asked& asked, AnswerQuestion& command);
  Result obey(Asked& asked, TeachLocation& command);
  Result obey(Asked& asked, RenameLocation& command);
  Result obey(Asked& asked, DeleteLocation& command);
  Result obey(Asked& asked, WhereIsRobot& command);
  Result obey(Asked& asked, ReadSensor& command);
  Result obey(Asked& asked, StartJog& command);
  Result obey(Asked& asked, KeepJog& command);
  Result obey(Asked& asked, EndJog& command);
  Result need_jog(ClientId client) const;
  Result begin_service(Asked& asked, std::function<Served()> work);
  Result need_locations() const;

  void pause(const std::string& by);
  void stop(const std::string& by);
  void tell_halt(const std::string& by);
  void start_again();
  void begin(Activity activity);
  /// Breakpoints of what runs are changed when the token next comes to an icon.
  Result change_breakpoints(Asked& asked, std::function<Reply()> change);
  void change_between();
  /// Notes what happens in the history, if there is one.
  void note_begin(RunRecord::Kind kind, const std::string& name, ClientId client);
  void note_step(const operations::Step& step);
  void note_end(const std::string& state, std::optional<int> code, const std::string& reason);
  void tell_breakpoints(const std::string& by);
  void forget_icons();

  /// Checks without the lock, then takes it.
  Result load(Asked& asked, LoadOperation command, const operations::Stop& stop);

  // While an operation runs, by the cell's thread.
  void arrives(const std::string& icon) override;
  void begins(const operations::Step& step) override;
  void done(const operations::Step& step) override;
  void work_on(const OperationJob& job);
  void work_on(SkillJob& job);
  void work_on(ServiceJob& job);

  operations::SkillRunner& runner;
  AskingRunner asking_runner;
  EventSink& sink;
  const DeskOptions options;
  const std::string epoch;

  mutable std::mutex mutex;
  std::condition_variable changed, answered;
  std::atomic<std::int64_t> now = 0;  // of the cell
  operations::Cell cell;
  mutable std::shared_ptr<const operations::Cell> cell_copy;  // null: it has changed
  Status status;
  std::map<ClientId, Client> clients;
  ClientId last_client = 0;
  std::optional<ClientId> holder;
  std::vector<ControlsAsked> asking;
  bool ending = false;
  std::size_t stops = 0, pauses = 0;                    // asked for so far
  std::size_t accepted_stops = 0, accepted_pauses = 0;  // … when the work was accepted
  std::vector<std::pair<std::function<Reply()>, Answerer>> between;
  std::optional<SkillJob> skill_job;
  std::optional<ClientId> stops_without;  // a skill alone is stopped when this client goes
  std::optional<ClientId> jogs;           // this client moves the arm by hand
  std::optional<OperationJob> operation_job;
  std::optional<ServiceJob> service_job;

  std::map<std::string, LastReading> readings;  // by sensor

  // Of the operation.
  std::shared_ptr<const LoadedFiles> loaded;
  std::map<std::pair<std::string, std::string>, ChangedParameter> changes;
  std::vector<operations::Breakpoint> breakpoints;
  std::map<std::string, IconState> icons;
  std::optional<Here> here;
  std::string step_before;            // icon of the last step that was not cut off
  bool cut_off = false;               // the last step was
  std::uint64_t operation_run = 0;    // of the history; 0: what runs next is a new one
  std::optional<std::size_t> answer;  // to the question that waits
  std::string answered_by;

  // Touched by clients while the cell is idle, by the cell's thread else; but for its pause() and stop().
  std::unique_ptr<operations::Executor> executor;
  std::size_t alone = 0;  // skills that ran alone
};

}  // namespace pal::server
