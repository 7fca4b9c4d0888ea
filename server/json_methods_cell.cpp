// The methods of the JSON protocol that tell of the cell: its state, clients, skills and sensors.
#include <array>

#include "pal/explain/embedded.hpp"
#include "server/json_call.hpp"
#include "server/json_live.hpp"

namespace pal::server {
namespace {

void explain(const Call& call) {
  const std::string code = call.members().text("code");
  for (const explain::EmbeddedPage& page : explain::embedded_pages())
    if (name(page.code) == code)
      return call.result({{"code", code}, {"title", title(page.code)}, {"markdown", page.markdown}});
  fail(Refusal::Why::absent, "there is no finding of this code");
}

void list_channels(const Call& call) {
  Json json = Json::array();
  if (call.context().channels != nullptr)
    for (const Channel& each : *call.context().channels) json.push_back(describe(each));
  call.result(json);
}

void requirements(const Call& call) {
  const std::string skill = call.members().text("skill", "");
  const auto facts = call.context().facts();
  if (!skill.empty() && !call.context().desk.skills().contains(skill))
    fail(Refusal::Why::absent, "the cell has no skill '" + skill.substr(0, 60) + "'");
  const auto measured =
      call.context().knowledge != nullptr ? call.context().knowledge->measured() : MeasuredRequirements();
  const double time_s = seconds(call.context().desk.status(call.client()).time);
  Json json = Json::array();
  for (const auto& [name, known] : facts->skills) {
    if (!skill.empty() && name != skill) continue;
    Json each{{"skill", name}, {"time_s", time_s}, {"requirements", Json::array()}};
    for (const KnownRequirement& requirement : known.requirements) {
      Json one = describe(requirement);
      const auto found = measured.find({name, requirement.name});
      if (found != measured.end()) {
        const double worst = found->second.worst;
        one["measured"] = worst;
        one["now"] = found->second.now;
        if (requirement.limit)
          one["margin"] = requirement.at_least ? worst - *requirement.limit : *requirement.limit - worst;
      }
      each["requirements"].push_back(std::move(one));
    }
    json.push_back(std::move(each));
  }
  call.result(json);
}

constexpr std::array cell_methods{
    Method{"state", Role::viewer, false,
           [](const Call& call) { call.result(describe(call.context().desk.status(call.client()))); }},
    Method{"snapshot", Role::viewer, false,
           // It may have all the texts of the operation.
           [](const Call& call) {
             call.beside(call.context().reading,
                         [&context = call.context(), client = call.client()](const Workshop::Stop&) {
                           return snapshot_json(context, client);
                         });
           }},
    Method{"clients", Role::viewer, false,
           [](const Call& call) { call.result(describe(call.context().desk.clients())); }},
    Method{"skills", Role::viewer, false,
           [](const Call& call) {
             const Desk& desk = call.context().desk;
             call.result(describe(desk.skills(), *call.context().facts(), *desk.cell()));
           }},
    Method{"sensors", Role::viewer, false,
           [](const Call& call) {
             const Desk& desk = call.context().desk;
             call.result(describe(desk.sensors(), desk.readings()));
           }},
    Method{"channels.list", Role::viewer, false, list_channels},
    Method{"requirements", Role::viewer, false, requirements},
    Method{"explain", Role::viewer, false, explain},
};

}  // namespace

Json snapshot_json(const SessionContext& context, ClientId client) {
  Json json{{"protocol", 2}, {"version", context.version}};
  json.update(describe(context.desk.snapshot(client)));
  json["offers"] = Json::array();
  if (context.store != nullptr) json["offers"].push_back("store");
  if (context.knowledge != nullptr) json["offers"].push_back("requirements");
  if (context.runs != nullptr) json["offers"].push_back("history");
  if (context.trials != nullptr) json["offers"].push_back("study");
  if (context.desk.locations() != nullptr) json["offers"].push_back("locations");
  if (context.desk.can_jog()) json["offers"].push_back("jog");
  if (context.channels != nullptr && !context.channels->empty()) json["offers"].push_back("channels");
  if (context.scene != nullptr) json["offers"].push_back("scene");
  if (context.recording != nullptr) json["offers"].push_back("replay");
  return json;
}

std::span<const Method> methods_of_the_cell() {
  return cell_methods;
}

}  // namespace pal::server
