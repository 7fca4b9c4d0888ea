// The methods of the JSON protocol on what the cell looks like, on places in it, and on runs that are looked
// at again.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>

#include "server/json_call.hpp"
#include "server/services.hpp"
#include "server/surface_frame.hpp"

namespace pal::server {
namespace {

constexpr std::int64_t greatest_recorded_run = std::int64_t{1} << 53;

/// To the micrometre: more digits are only longer.
template <class Numbers>
Json short_numbers(const Numbers& numbers) {
  constexpr double digits = 1e6;
  Json json = Json::array();
  for (const double each : numbers) json.push_back(std::round(each * digits) / digits);
  return json;
}

Json scene_json(const ScenePose& pose) {
  return {{"position", short_numbers(pose.position)}, {"turn", short_numbers(pose.turn)}};
}

Json scene_json(const SceneFrame& frame) {
  Json json = scene_json(frame.pose);
  json["body"] = frame.body;
  return json;
}

Json scene_json(const SceneShape& shape) {
  static constexpr std::array kinds{"plane", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh"};
  Json json = scene_json(shape.pose);
  json["kind"] = kinds[static_cast<std::size_t>(shape.kind)];
  json["body"] = shape.body;
  json["size"] = short_numbers(shape.size);
  json["colour"] = short_numbers(shape.colour);
  if (!shape.triangles.empty()) {
    json["corners"] = short_numbers(shape.corners);
    json["triangles"] = shape.triangles;
  }
  return json;
}

const Scene& scene_of(const SessionContext& context) {
  if (context.scene == nullptr) fail(Refusal::Why::absent, "this cell does not tell what it looks like");
  return *context.scene;
}

void get_scene(const Call& call) {
  const Scene& scene = scene_of(call.context());
  Json json{{"bodies", Json::array()}, {"shapes", Json::array()}};
  for (const SceneBody& body : scene.bodies) {
    Json one = scene_json(body.pose);
    one["name"] = body.name;
    one["moves"] = body.moves;
    json["bodies"].push_back(std::move(one));
  }
  for (const SceneShape& shape : scene.shapes) json["shapes"].push_back(scene_json(shape));
  json["tip"] = scene_json(scene.tip);
  json["sensor"] = scene_json(scene.sensor);
  call.result(json);
}

void place_locations(const Call& call) {
  const Scene& scene = scene_of(call.context());
  Json json = Json::array();
  const Locations* book = call.context().desk.locations();
  if (book != nullptr && scene.place)
    for (const Location& each : book->list()) {
      Json one = scene_json(scene.place(each.pose));
      one["location"] = each.name;
      json.push_back(std::move(one));
    }
  call.result(json);
}

/// Where a taught location is in the world.
ScenePose place_of(const Call& call, const Scene& scene, const char* member) {
  const std::string name = call.members().text(member);
  const Locations* book = call.context().desk.locations();
  if (book == nullptr || !scene.place || !scene.figures)
    fail(Refusal::Why::absent, "this cell does not tell where its locations are");
  for (const Location& each : book->list())
    if (each.name == name) return scene.place(each.pose);
  fail(Refusal::Why::absent, fmt::format("there is no location '{}'", name));
}

void pose_on_surface(const Call& call) {
  const Scene& scene = scene_of(call.context());
  const auto frame = surface_frame(place_of(call, scene, "origin"), place_of(call, scene, "along"),
                                   place_of(call, scene, "beside"));
  if (!frame)
    fail(Refusal::Why::wrong,
         "the three locations are no surface: they lie on a line, or two are at one place",
         "teach the second 5 mm away or more, and the third beside their line");
  call.result({{"pose", scene.figures(*frame)}});
}

const RunRecording& recording_of(const SessionContext& context) {
  if (context.recording == nullptr) fail(Refusal::Why::absent, "this server records no runs");
  return *context.recording;
}

/// The numbers as bytes, little endian, and these as text of 64 letters.
std::string letters_of(const std::vector<float>& numbers) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes(numbers.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63U];
  }
  return text;
}

void list_recordings(const Call& call) {
  call.beside(call.context().disk,
              [&recording = recording_of(call.context())](const Workshop::Stop&) -> Json {
                Json json = Json::array();
                for (const RecordedRun& each : with_store([&] { return recording.list(); }))
                  json.push_back({{"run", each.run},
                                  {"begin_s", seconds(each.begin)},
                                  {"end_s", seconds(each.end)},
                                  {"channels", each.channels}});
                return json;
              });
}

void read_recording(const Call& call) {
  constexpr std::int64_t usual = 300, most = 3000;
  const Members& members = call.members();
  const auto run = static_cast<std::uint64_t>(members.whole("run", 1, greatest_recorded_run));
  const std::string channel = members.text("channel");
  const auto limit = static_cast<std::size_t>(members.may_be_whole("limit", 1, most).value_or(usual));
  Duration after = Duration::min();
  if (const Json* given = members.find("after_s"); given != nullptr) {
    if (!given->is_number() || !(std::abs(given->get<double>()) <= 1e9))
      fail(bad_parameters, "'after_s' is a time of the cell in seconds");
    after = Duration(std::llround(given->get<double>() * 1e9));
  }
  call.beside(
      call.context().disk,
      [&recording = recording_of(call.context()), run, channel, after, limit](const Workshop::Stop&) -> Json {
        const RecordedPage page = with_store([&] { return recording.read(run, channel, after, limit); });
        Json json{{"channel", channel},
                  {"times_s", Json::array()},
                  {"rows", page.rows},
                  {"numbers", letters_of(page.numbers)},
                  {"more", page.more}};
        for (const Duration time : page.times) json["times_s"].push_back(seconds(time));
        return json;
      });
}

constexpr std::array scene_methods{
    Method{"scene.get", Role::viewer, false, get_scene},
    Method{"scene.locations", Role::viewer, false, place_locations},
    Method{"locations.surface", Role::viewer, false, pose_on_surface},
    Method{"replay.list", Role::viewer, false, list_recordings},
    Method{"replay.read", Role::viewer, false, read_recording},
};

}  // namespace

std::span<const Method> methods_of_the_scene() {
  return scene_methods;
}

}  // namespace pal::server
