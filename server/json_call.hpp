// One request of the JSON protocol, as the method sees it that answers it.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "server/json_requests.hpp"
#include "server/session.hpp"
#include "server/workshop.hpp"

namespace pal::server {

/// The message that answers the request of this id.
std::string answer_text(const Json& id, const Json& result);

/// The session behind a call; what a call needs of it.
class CallHome {
 public:
  virtual ~CallHome() = default;
  virtual SessionContext& context() = 0;
  virtual ClientId client() const = 0;
  virtual Role role() const = 0;
  virtual void send_result(const Json& id, const Json& result) = 0;
  /// The whole message, from answer_text().
  virtual void send_message(std::string message) = 0;
  virtual void send_problem(const Json& id, const Problem& problem) = 0;
  /// So that `cancel` finds it, until it is answered.
  virtual void note_ticket(const Json& id, const Workshop::Ticket& ticket) = 0;
  /// Commands of this client wait until the call is answered, so that they keep their order. Stops and pauses
  /// do not wait.
  virtual void hold_commands(bool hold) = 0;
  /// False once the session has ended.
  virtual std::weak_ptr<bool> alive() const = 0;
};

/// May be copied; all copies are the same call. Answered once, in the thread of the sessions.
class Call {
 public:
  Call(CallHome& home, Members members, Json id, bool answered)
      : home_(&home), members_(std::move(members)), id_(std::move(id)), answered_(answered) {}

  const Members& members() const { return members_; }
  SessionContext& context() const { return home_->context(); }
  ClientId client() const { return home_->client(); }
  Role role() const { return home_->role(); }

  void result(const Json& result) const {
    if (answered_) home_->send_result(id_, result);
  }
  void refuse(const Problem& problem) const {
    if (answered_) home_->send_problem(id_, problem);
  }
  /// Asks the desk; `describe` makes the result.
  void ask(Command command, std::function<Json(const Done&)> describe) const;
  void ask(Command command) const;
  /// Does the work beside the desk. It gives the result, or throws Problem.
  void beside(Workshop& workshop, std::function<Json(const Workshop::Stop&)> work) const;
  /// Loads the operation beside the desk; commands that come behind wait for it. `find` completes the files.
  void load(LoadOperation command, std::function<void(LoadOperation&)> find) const;

 private:
  void answer_with(std::variant<std::string, Problem>& outcome) const;

  CallHome* home_;
  Members members_;
  Json id_;
  bool answered_;
};

struct Method {
  std::string_view name;
  Role least;
  /// It gives a command to the desk, and so keeps its place behind an operation that is being loaded.
  bool commands;
  void (*answer)(const Call& call);
};

// The methods by their groups; json_session.cpp has those that change the session itself.
std::span<const Method> methods_of_the_cell();
std::span<const Method> methods_of_controls();
std::span<const Method> methods_of_operations();
std::span<const Method> methods_of_texts();
std::span<const Method> methods_of_the_store();
std::span<const Method> methods_of_the_robot();
std::span<const Method> methods_of_jogs();
std::span<const Method> methods_of_the_history();
std::span<const Method> methods_of_studies();
std::span<const Method> methods_of_the_scene();

/// The whole present state, as hello and snapshot give it.
Json snapshot_json(const SessionContext& context, ClientId client);

/// Null: there is none.
const Method* find_method(std::string_view name);

}  // namespace pal::server
