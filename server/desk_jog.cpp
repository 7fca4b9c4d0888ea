// How the desk lets a client move the arm by hand: the skill `jog` runs for it, and its orders go to the
// pendant. Whether the arm may go on is decided by that skill, which stops when no order comes.
#include "server/desk_parts.hpp"

namespace pal::server {

Desk::Parts::Result Desk::Parts::obey(Asked& asked, StartJog& command) {
  if (options.pendant == nullptr)
    return Refusal{Refusal::Why::absent, "the arm of this cell cannot be moved by hand",
                   "its time must go by the wall clock: serve it without --fast"};
  RunSkill skill{std::string(skill_by_hand), std::move(command.parameters), false};
  if (auto refusal = obey(asked, skill)) return refusal;
  jogs = asked.client;
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::need_jog(ClientId client) const {
  if (jogs == client && !status.stopping) return std::nullopt;
  return Refusal{Refusal::Why::nothing, "this client does not move the arm by hand", "begin: jog.start"};
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, KeepJog& command) {
  if (auto refusal = need_jog(asked.client)) return refusal;
  options.pendant->order(command.axes, true);
  return std::nullopt;
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, EndJog&) {
  if (auto refusal = need_jog(asked.client)) return refusal;
  options.pendant->order({}, false);
  return std::nullopt;
}

}  // namespace pal::server
