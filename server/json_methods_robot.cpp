// The methods of the JSON protocol on the robot and its sensors between skills: locations, readings.
#include <algorithm>
#include <array>
#include <cmath>

#include "server/json_call.hpp"

namespace pal::server {
namespace {

constexpr std::int64_t greatest_of_locations = std::int64_t{1} << 53;

std::optional<std::uint64_t> version_of(const Call& call) {
  const auto version = call.members().may_be_whole("based_on", 0, greatest_of_locations);
  return version ? std::optional<std::uint64_t>(*version) : std::nullopt;
}

std::optional<PoseFigures> pose_of(const Call& call) {
  const Json* pose = call.members().find("pose");
  if (pose == nullptr) return std::nullopt;
  const auto fits = [](const Json& each) { return each.is_number() && std::abs(each.get<double>()) <= 1e5; };
  if (!pose->is_array() || pose->size() != 6 || !std::ranges::all_of(*pose, fits))
    fail(bad_parameters, "'pose' is x, y, z in mm, then O, A, T in degrees");
  return pose->get<PoseFigures>();
}

Json location_json(const Done& done) {
  return done.location ? describe(*done.location) : Json::object();
}

void list_locations(const Call& call) {
  const Locations* book = call.context().desk.locations();
  if (book == nullptr) fail(Refusal::Why::absent, "this cell tells no locations");
  Json json = Json::array();
  for (const Location& each : book->list()) json.push_back(describe(each));
  call.result(json);
}

void read_sensor(const Call& call) {
  const std::string sensor = call.members().text("sensor");
  call.ask(ReadSensor{sensor}, [sensor, unit = [&] {
             const auto& all = call.context().desk.sensors();
             const auto found = all.find(sensor);
             return found == all.end() ? std::string() : found->second.unit;
           }()](const Done& done) {
    return Json{{"sensor", sensor},
                {"value", done.reading.value_or(0)},
                {"unit", unit},
                {"time_s", seconds(done.end)}};
  });
}

constexpr std::array robot_methods{
    Method{"sensor.read", Role::viewer, true, read_sensor},
    Method{"locations.here", Role::viewer, true,
           [](const Call& call) {
             call.ask(WhereIsRobot{}, [](const Done& done) -> Json {
               if (!done.location || !done.location->joints) return Json::object();
               return {{"pose", done.location->pose}, {"joints", *done.location->joints}};
             });
           }},
    Method{"locations.list", Role::viewer, false, list_locations},
    Method{"locations.teach", Role::programmer, true,
           [](const Call& call) {
             call.ask(TeachLocation{call.members().text("location"), version_of(call), pose_of(call)},
                      location_json);
           }},
    Method{"locations.rename", Role::programmer, true,
           [](const Call& call) {
             call.ask(
                 RenameLocation{call.members().text("location"), call.members().text("to"), version_of(call)},
                 location_json);
           }},
    Method{"locations.delete", Role::programmer, true,
           [](const Call& call) {
             call.ask(DeleteLocation{call.members().text("location"), version_of(call)});
           }},
};

}  // namespace

std::span<const Method> methods_of_the_robot() {
  return robot_methods;
}

}  // namespace pal::server
