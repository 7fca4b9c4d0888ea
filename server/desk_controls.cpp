// Who has the controls, who may take them, and holds.
#include <fmt/format.h>

#include <algorithm>

#include "pal/support/text_width.hpp"
#include "server/desk_parts.hpp"

namespace pal::server {
namespace {

/// The least role that may give a command; those that need the controls are refused by them as well.
struct LeastRole {
  Role operator()(const Pause&) const { return Role::viewer; }
  Role operator()(const Stop&) const { return Role::viewer; }
  Role operator()(const ReleaseControls&) const { return Role::viewer; }
  Role operator()(const WhereIsRobot&) const { return Role::viewer; }
  Role operator()(const ReadSensor&) const { return Role::viewer; }
  Role operator()(const RunSkill&) const { return Role::programmer; }
  Role operator()(const StartJog&) const { return Role::programmer; }
  Role operator()(const KeepJog&) const { return Role::programmer; }
  Role operator()(const EndJog&) const { return Role::programmer; }
  Role operator()(const TeachLocation&) const { return Role::programmer; }
  Role operator()(const RenameLocation&) const { return Role::programmer; }
  Role operator()(const DeleteLocation&) const { return Role::programmer; }
  template <class Other>
  Role operator()(const Other&) const {
    return Role::operating;
  }
};

}  // namespace

Desk::Parts::Result Desk::Parts::need_role(const Asked& asked, const Command& command) const {
  const auto found = clients.find(asked.client);
  if (found == clients.end()) return Refusal{Refusal::Why::role, "this client is not here"};
  Role least = std::visit(LeastRole{}, command);
  const auto* load = std::get_if<LoadOperation>(&command);
  if (load != nullptr && !load->stored) least = Role::programmer;
  if (found->second.role >= least) return std::nullopt;
  return Refusal{
      Refusal::Why::role,
      fmt::format("{} may not do that", found->second.role == Role::viewer ? "a viewer" : "an operator"),
      load != nullptr && least == Role::programmer && found->second.role == Role::operating
          ? "load an operation of the store by its name"
          : fmt::format("show the token of a{} {}", least == Role::operating ? "n" : "", name(least))};
}

void Desk::Parts::give_controls(std::optional<ClientId> client, const std::string& reason) {
  if (holder == client) return;
  holder = client;
  status.holder = client ? name_of(*client) : "";
  if (client) std::erase_if(asking, [client](const ControlsAsked& each) { return each.client == *client; });
  publish(ControlsChanged{status.holder, client, reason});
}

// Controls are taken by what is obeyed, never by what is refused.
Desk::Parts::Result Desk::Parts::need_controls(ClientId client) const {
  if (ending) return Refusal{Refusal::Why::ending, "the server ends"};
  if (holder && *holder != client)
    return Refusal{
        Refusal::Why::not_yours,
        fmt::format("'{}' has the controls; other clients may only pause and stop", status.holder)};
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::need_rest() const {
  if (status.activity == Activity::idle) return std::nullopt;
  if (status.activity == Activity::service)
    return Refusal{Refusal::Why::busy, "a sensor is read or a location changed", "ask again"};
  return Refusal{Refusal::Why::busy,
                 fmt::format("{} runs; pause or stop it first",
                             status.activity == Activity::skill ? "a skill" : "an operation")};
}

Desk::Parts::Result Desk::Parts::need_operation() const {
  if (executor) return std::nullopt;
  return Refusal{Refusal::Why::nothing, "no operation is loaded"};
}

Desk::Parts::Result Desk::Parts::need_no_hold() const {
  if (!status.hold) return std::nullopt;
  return Refusal{Refusal::Why::held,
                 fmt::format("'{}' holds the cell{}{}", status.hold->by,
                             status.hold->reason.empty() ? "" : ": ", status.hold->reason),
                 "who set the hold, or a higher role, releases it: hold.release"};
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, TakeControls& command) {
  if (ending) return need_controls(asked.client);
  if (holder && *holder != asked.client) {
    if (!command.force) return need_controls(asked.client);
    if (clients.at(asked.client).role != Role::programmer)
      return Refusal{Refusal::Why::role, "only a programmer may take the controls from another client",
                     "ask for them: controls.ask"};
    if (auto refusal = need_rest()) return refusal;
  }
  give_controls(asked.client, printable(command.reason));
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, AskForControls& command) {
  if (ending) return need_controls(asked.client);
  if (!holder || *holder == asked.client)
    return Refusal{Refusal::Why::nothing, holder ? "this client has the controls" : "nobody has the controls",
                   holder ? "" : "take them: controls.take"};
  std::erase_if(asking, [&](const ControlsAsked& each) { return each.client == asked.client; });
  asking.push_back({asked.client, name_of(asked.client), printable(command.reason)});
  publish(asking.back());
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, GiveControls& command) {
  if (ending) return need_controls(asked.client);
  if (holder != asked.client) {
    if (holder) return need_controls(asked.client);
    return Refusal{Refusal::Why::not_yours, "this client does not have the controls", "take them first"};
  }
  const auto to = clients.find(command.to);
  if (to == clients.end())
    return Refusal{Refusal::Why::absent, fmt::format("there is no client {}", command.to),
                   "'clients' lists those that are here"};
  if (to->second.role == Role::viewer)
    return Refusal{Refusal::Why::role, fmt::format("'{}' is a viewer", to->second.name),
                   "choose another client"};
  give_controls(command.to);
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, ReleaseControls&) {
  if (holder == asked.client) give_controls(std::nullopt);
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, SetHold& command) {
  if (ending) return Refusal{Refusal::Why::ending, "the server ends"};
  const Client& client = clients.at(asked.client);
  if (status.hold && status.hold->client != asked.client && status.hold->role >= client.role)
    return need_no_hold();
  status.hold = Hold{client.name, asked.client, client.role, printable(command.reason),
                     std::chrono::system_clock::now()};
  publish(HoldChanged{status.hold, client.name});
  if (status.activity == Activity::operation) pause(client.name);
  if (jogs) stop(client.name);
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, ReleaseHold&) {
  if (!status.hold) return Refusal{Refusal::Why::nothing, "there is no hold"};
  const Client& client = clients.at(asked.client);
  const bool gone = !clients.contains(status.hold->client);
  const bool higher = client.role > status.hold->role || (gone && client.role == Role::programmer);
  if (status.hold->client != asked.client && !higher)
    return Refusal{Refusal::Why::held, fmt::format("'{}' set the hold", status.hold->by),
                   gone ? "it has gone; a programmer releases it" : "it, or a higher role, releases it"};
  status.hold.reset();
  publish(HoldChanged{std::nullopt, client.name});
  return std::nullopt;
}

}  // namespace pal::server
