#include "server/locations.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/disk_file.hpp"

namespace pal::server {
namespace {

namespace fs = std::filesystem;
using LocationsJson = nlohmann::ordered_json;

constexpr const char* locations_file = "locations.json";
constexpr std::size_t largest_locations_file = std::size_t{1} << 24;

LocationsJson json_of_location(const Location& location) {
  LocationsJson json{{"pose", location.pose}, {"version", location.version}, {"by", location.by}};
  if (location.joints) json["joints"] = *location.joints;
  if (location.changed) json["changed_ms"] = milliseconds(*location.changed);
  return json;
}

/// Throws LocationsJson::exception.
Location location_of(const std::string& name, const LocationsJson& json) {
  Location result;
  result.name = name;
  result.pose = json.at("pose").get<PoseFigures>();
  for (const double figure : result.pose)
    if (!std::isfinite(figure))
      throw LocationsJson::other_error::create(501, "a figure is not finite", &json);
  if (json.contains("joints")) result.joints = json["joints"].get<std::array<double, 6>>();
  result.version = json.at("version").get<std::uint64_t>();
  if (json.contains("changed_ms"))
    result.changed = WallTime(std::chrono::milliseconds(json["changed_ms"].get<std::int64_t>()));
  result.by = json.value("by", "");
  return result;
}

}  // namespace

Locations::Locations(const std::map<std::string, PoseFigures>& made, std::string folder)
    : folder_(std::move(folder)) {
  if (!folder_.empty()) {
    std::error_code problem;
    fs::create_directories(folder_, problem);
    if (problem) refuse(Refusal::Why::failed, folder_ + ": " + problem.message());
    read();
  }
  for (const auto& [name, pose] : made)
    if (!locations_.contains(name) && !deleted_.contains(name))
      locations_[name] = Location{name, pose, {}, 1, {}, {}};
}

void Locations::read() {
  const std::string path = folder_ + "/" + locations_file;
  if (!fs::exists(path)) return;
  const std::string text = DiskFile(path, O_RDONLY).read(path, largest_locations_file);
  try {
    const LocationsJson json = LocationsJson::parse(text);
    if (json.at("locations-format") != 1)
      refuse(Refusal::Why::failed, path + ": its format is not known", "it was written by a newer program");
    for (const auto& [name, each] : json.at("locations").items())
      locations_.emplace(name, location_of(name, each));
    for (const auto& [name, version] : json.at("deleted").items())
      deleted_.emplace(name, version.get<std::uint64_t>());
  } catch (const LocationsJson::exception& problem) {
    refuse(Refusal::Why::failed, fmt::format("{}: {}", path, problem.what()),
           "move the file away, and the cell has the locations with which it was made");
  }
}

std::vector<Location> Locations::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<Location> result;
  for (const auto& [name, location] : locations_) result.push_back(location);
  return result;
}

std::set<std::string> Locations::names() const {
  const std::lock_guard lock(mutex_);
  std::set<std::string> result;
  for (const auto& [name, location] : locations_) result.insert(name);
  return result;
}

void Locations::check(const std::string& name, std::optional<std::uint64_t> based_on) const {
  const auto found = locations_.find(name);
  if (found == locations_.end())
    refuse(Refusal::Why::absent, fmt::format("there is no location '{}'", name),
           "locations.list names those that there are");
  if (!based_on || *based_on == found->second.version) return;
  Refusal refusal{Refusal::Why::newer,
                  fmt::format("'{}' has version {} meanwhile", name, found->second.version),
                  "look where it is now, then change it based on that version"};
  refusal.newest = found->second.version;
  throw StoreProblem{refusal};
}

void Locations::keep(std::map<std::string, Location> changed, std::map<std::string, std::uint64_t> deleted) {
  if (!folder_.empty()) {
    LocationsJson json{{"locations-format", 1},
                       {"locations", LocationsJson::object()},
                       {"deleted", LocationsJson::object()}};
    for (const auto& [name, location] : changed) json["locations"][name] = json_of_location(location);
    for (const auto& [name, version] : deleted) json["deleted"][name] = version;
    replace_file(folder_, locations_file,
                 json.dump(1, ' ', false, LocationsJson::error_handler_t::replace) + "\n");
  }
  locations_ = std::move(changed);
  deleted_ = std::move(deleted);
}

Location Locations::teach(const std::string& name, const Location& here,
                          std::optional<std::uint64_t> based_on, const std::string& by) {
  const std::lock_guard lock(mutex_);
  const auto found = locations_.find(name);
  if (based_on && *based_on > 0) check(name, based_on);
  if (based_on == std::uint64_t{0} && found != locations_.end()) {
    Refusal refusal{Refusal::Why::newer, fmt::format("there is a location '{}'", name),
                    "choose another name, or base it on that version"};
    refusal.newest = found->second.version;
    throw StoreProblem{refusal};
  }
  if (found == locations_.end() && locations_.size() >= most)
    refuse(Refusal::Why::too_much, fmt::format("the cell has {} locations", most), "delete some");
  auto changed = locations_;
  auto deleted = deleted_;
  const std::uint64_t before = found != locations_.end() ? found->second.version
                               : deleted.contains(name)  ? deleted[name]
                                                         : 0;
  deleted.erase(name);
  const Location fresh{name, here.pose, here.joints, before + 1, std::chrono::system_clock::now(), by};
  changed[name] = fresh;
  keep(std::move(changed), std::move(deleted));
  return fresh;
}

Location Locations::rename(const std::string& name, const std::string& to,
                           std::optional<std::uint64_t> based_on, const std::string& by) {
  const std::lock_guard lock(mutex_);
  check(name, based_on);
  if (locations_.contains(to))
    refuse(Refusal::Why::exists, fmt::format("there is a location '{}'", to), "choose another name");
  auto changed = locations_;
  auto deleted = deleted_;
  Location moved = changed.at(name);
  changed.erase(name);
  deleted[name] = moved.version;
  moved.name = to;
  moved.version = (deleted.contains(to) ? deleted[to] : 0) + 1;
  moved.changed = std::chrono::system_clock::now();
  moved.by = by;
  deleted.erase(to);
  changed[to] = moved;
  keep(std::move(changed), std::move(deleted));
  return moved;
}

std::uint64_t Locations::remove(const std::string& name, std::optional<std::uint64_t> based_on) {
  const std::lock_guard lock(mutex_);
  check(name, based_on);
  auto changed = locations_;
  auto deleted = deleted_;
  const std::uint64_t version = changed.at(name).version;
  deleted[name] = version;
  changed.erase(name);
  keep(std::move(changed), std::move(deleted));
  return version;
}

}  // namespace pal::server
