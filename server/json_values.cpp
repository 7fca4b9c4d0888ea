#include "server/json_values.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <array>

#include "operations/missing_value.hpp"
#include "operations/step_log.hpp"

namespace pal::server {

double seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e9;
}

std::string wall_text(WallTime time) {
  const auto whole = std::chrono::time_point_cast<std::chrono::milliseconds>(time);
  const auto second = std::chrono::floor<std::chrono::seconds>(whole);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                     (whole - second).count());
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json describe(const operations::Value& value) {
  return std::visit([](const auto& each) { return Json(each); }, value);
}

Json value_or_null(const std::optional<operations::Value>& value) {
  return value ? describe(*value) : Json();
}

Json describe(const std::vector<operations::Parameter>& parameters) {
  Json json = Json::object();
  for (const operations::Parameter& each : parameters)
    json[each.name] = each.source.written() ? describe(each.value) : Json(operations::to_text(each));
  return json;
}

Json describe(const std::optional<Hold>& hold) {
  if (!hold) return nullptr;
  return {{"by", hold->by},
          {"client", hold->client},
          {"role", name(hold->role)},
          {"reason", hold->reason},
          {"since", wall_text(hold->since)}};
}

Json describe(const OpenQuestion& question) {
  return {{"icon", question.question.icon},
          {"text", question.question.text},
          {"answers", question.question.answers},
          {"since_s", seconds(question.since)},
          {"since", wall_text(question.since_wall)}};
}

Json describe(const ControlsAsked& asking) {
  return {{"client", asking.client}, {"name", asking.name}, {"reason", asking.reason}};
}

Json describe(const operations::Source& source) {
  using Kind = operations::Source::Kind;
  if (source.kind == Kind::count) return {{"count-of", source.icon}};
  if (source.kind == Kind::argument) return {{"argument", source.name}};
  return {{"output-of", source.icon}, {"name", source.name}};
}

Json describe_step(const operations::Step& step, bool ended) {
  Json json = Json::parse(operations::log_line(step));
  if (ended) return json;
  for (const char* later :
       {"reading", "readings", "answer", "figures", "measured", "kind", "code", "reason", "end_s"})
    json.erase(later);
  return json;
}

Json describe(const StoredEntry& entry) {
  return {{"name", entry.name},
          {"version", entry.version},
          {"operation", entry.operation},
          {"saved", wall_text(entry.saved)},
          {"by", entry.by},
          {"note", entry.note},
          {"size", entry.size}};
}

Json describe(const Location& location) {
  return {{"location", location.name},
          {"pose", location.pose},
          {"joints", location.joints ? Json(*location.joints) : Json()},
          {"version", location.version},
          {"changed", location.changed ? Json(wall_text(*location.changed)) : Json()},
          {"by", location.by}};
}

Json describe(const Done& done, bool skill) {
  Json json = Json::object();
  if (!skill) return json;
  static constexpr std::array kinds{"normal", "contingency", "error", "stopped"};
  json["kind"] = kinds[static_cast<std::size_t>(done.result.kind)];
  json["code"] = done.result.code;
  json["reason"] = done.result.reason;
  if (!done.result.figures.empty())
    for (const operations::Figure& figure : done.result.figures) json["figures"][figure.name] = figure.value;
  json["begin_s"] = seconds(done.begin);
  json["end_s"] = seconds(done.end);
  return json;
}

}  // namespace pal::server
