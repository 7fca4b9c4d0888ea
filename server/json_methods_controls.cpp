// The methods of the JSON protocol on controls and holds.
#include <array>

#include "server/json_call.hpp"

namespace pal::server {
namespace {

constexpr std::size_t longest_reason = 200;

constexpr std::array control_methods{
    Method{"controls.take", Role::operating, true,
           [](const Call& call) {
             call.ask(TakeControls{call.members().short_text("reason", longest_reason),
                                   call.members().truth("force")});
           }},
    Method{"controls.ask", Role::operating, true,
           [](const Call& call) {
             call.ask(AskForControls{call.members().short_text("reason", longest_reason)});
           }},
    Method{"controls.give", Role::operating, true,
           [](const Call& call) {
             constexpr std::int64_t most = std::int64_t{1} << 53;
             call.ask(GiveControls{static_cast<ClientId>(call.members().whole("client", 1, most))});
           }},
    Method{"controls.release", Role::viewer, true, [](const Call& call) { call.ask(ReleaseControls{}); }},
    Method{"hold.set", Role::operating, false,
           [](const Call& call) { call.ask(SetHold{call.members().short_text("reason", longest_reason)}); }},
    Method{"hold.release", Role::operating, true, [](const Call& call) { call.ask(ReleaseHold{}); }},
};

}  // namespace

std::span<const Method> methods_of_controls() {
  return control_methods;
}

}  // namespace pal::server
