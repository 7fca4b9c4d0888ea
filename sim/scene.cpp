#include "sim/scene.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace pal::sim {

namespace fs = std::filesystem;

SceneError::SceneError(std::string place, std::string cause, std::string hint)
    : std::runtime_error(place + ": " + cause + (hint.empty() ? "" : " (" + hint + ")")),
      place_(std::move(place)),
      cause_(std::move(cause)),
      hint_(std::move(hint)) {}

namespace {

// The files that <include file="…"/> in this text names.
std::set<std::string> included_by(const fs::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::set<std::string> names;
  for (std::size_t at = text.find("<include"); at != std::string::npos; at = text.find("<include", at + 1)) {
    const std::size_t open = text.find('"', at);
    const std::size_t close = open == std::string::npos ? open : text.find('"', open + 1);
    if (close != std::string::npos) names.insert(text.substr(open + 1, close - open - 1));
  }
  return names;
}

}  // namespace

std::vector<Scene> list_scenes(const std::vector<fs::path>& folders) {
  std::vector<Scene> scenes;
  std::set<std::string> parts{"puma560.xml", "cell.xml"};  // what scenes in MJCF include
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const bool mjcf = entry.path().extension() == ".xml";
      if (!mjcf && entry.path().extension() != ".scene") continue;
      if (mjcf) parts.merge(included_by(entry.path()));
      const std::string name = entry.path().stem().string();
      const auto same = [&](const Scene& scene) { return scene.name == name; };
      if (std::none_of(scenes.begin(), scenes.end(), same)) scenes.push_back({name, entry.path()});
    }
  }
  std::erase_if(scenes, [&](const Scene& scene) { return parts.contains(scene.file.filename().string()); });
  std::sort(scenes.begin(), scenes.end(), [](const Scene& a, const Scene& b) { return a.name < b.name; });
  return scenes;
}

Scene find_scene(const std::string& name_or_path, const std::vector<fs::path>& folders) {
  const fs::path path(name_or_path);
  if (name_or_path.find('/') != std::string::npos || path.extension() == ".xml" ||
      path.extension() == ".scene") {
    if (!fs::exists(path)) throw SceneError(name_or_path, "there is no such file", "check the path");
    if (fs::is_directory(path))
      throw SceneError(name_or_path, "this is a folder, not the file of a scene",
                       "name a file in it, or write --scenes " + name_or_path + " and the name of a scene");
    return {path.stem().string(), path};
  }
  std::string names;
  for (const Scene& scene : list_scenes(folders)) {
    if (scene.name == name_or_path) return scene;
    names += (names.empty() ? "" : ", ") + scene.name;
  }
  throw SceneError(
      "scene '" + name_or_path + "'", "there is no scene of this name",
      names.empty() ? "no folder of scenes was found; give the path of a scene file" : "there are " + names);
}

}  // namespace pal::sim
