// The methods of the JSON protocol that tell of the cell: its state, clients, skills and sensors.
#include <array>

#include "pal/explain/embedded.hpp"
#include "server/json_call.hpp"

namespace pal::server {
namespace {

void explain(const Call& call) {
  const std::string code = call.members().text("code");
  for (const explain::EmbeddedPage& page : explain::embedded_pages())
    if (name(page.code) == code)
      return call.result({{"code", code}, {"title", title(page.code)}, {"markdown", page.markdown}});
  fail(Refusal::Why::absent, "there is no finding of this code");
}

constexpr std::array cell_methods{
    Method{"state", Role::viewer, false,
           [](const Call& call) { call.result(describe(call.context().desk.status(call.client()))); }},
    Method{"snapshot", Role::viewer, false,
           [](const Call& call) { call.result(snapshot_json(call.context(), call.client())); }},
    Method{"clients", Role::viewer, false,
           [](const Call& call) { call.result(describe(call.context().desk.clients())); }},
    Method{"skills", Role::viewer, false,
           [](const Call& call) {
             const Desk& desk = call.context().desk;
             call.result(describe(desk.skills(), *call.context().facts(), desk.cell()->unable));
           }},
    Method{"sensors", Role::viewer, false,
           [](const Call& call) { call.result(describe(call.context().desk.sensors())); }},
    Method{"explain", Role::viewer, false, explain},
};

}  // namespace

Json snapshot_json(const SessionContext& context, ClientId client) {
  Json json{{"protocol", 2}, {"version", context.version}};
  json.update(describe(context.desk.snapshot(client)));
  json["offers"] = Json::array();
  if (context.store != nullptr) json["offers"].push_back("store");
  if (context.knowledge != nullptr) json["offers"].push_back("requirements");
  return json;
}

std::span<const Method> methods_of_the_cell() {
  return cell_methods;
}

}  // namespace pal::server
