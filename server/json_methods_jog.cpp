// The methods of the JSON protocol by which a person moves the arm by hand.
#include <algorithm>
#include <array>
#include <cmath>

#include "server/json_call.hpp"

namespace pal::server {
namespace {

constexpr std::array frames{"joints", "world", "tool"};  // by the number that the skill has for each

void start(const Call& call) {
  const Members& members = call.members();
  const auto frame = std::ranges::find(frames, members.text("frame"));
  if (frame == frames.end()) fail(bad_parameters, "'frame' is joints, world or tool");
  StartJog command;
  command.parameters.push_back({"frame", static_cast<double>(frame - frames.begin()), {}, {}});
  for (const char* name : {"speed", "turn", "way", "angle", "contact-force"})
    if (const Json* value = members.find(name))
      command.parameters.push_back({name, value_of(name, *value), {}, {}});
  call.ask(std::move(command), [](const Done& done) { return describe(done, true); });
}

void keep(const Call& call) {
  const Json* axes = call.members().find("axes");
  const auto fits = [](const Json& each) { return each.is_number() && std::abs(each.get<double>()) <= 1; };
  if (axes == nullptr || !axes->is_array() || axes->size() != 6 || !std::ranges::all_of(*axes, fits))
    fail(bad_parameters, "'axes' is six numbers from -1 to 1");
  call.ask(KeepJog{axes->get<JogAxes>()});
}

constexpr std::array jog_methods{
    Method{"jog.start", Role::programmer, true, start},
    Method{"jog.keep", Role::programmer, false, keep},
    Method{"jog.stop", Role::programmer, false, [](const Call& call) { call.ask(EndJog{}); }},
};

}  // namespace

std::span<const Method> methods_of_jogs() {
  return jog_methods;
}

}  // namespace pal::server
