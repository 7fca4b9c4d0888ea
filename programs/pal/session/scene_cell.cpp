#include "programs/pal/session/scene_cell.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "programs/pal/session/process.hpp"

namespace pal::program {
namespace {

std::string workcell_program() {
  std::error_code problem;
  const auto ours = std::filesystem::read_symlink("/proc/self/exe", problem);
  const auto beside = ours.parent_path() / "workcell";
  return !problem && std::filesystem::exists(beside, problem) ? beside.string() : "workcell";
}

/// Throws nlohmann::json::exception.
SceneCell cell_of(const nlohmann::json& told) {
  const auto sensors = [&told](const char* name) {
    operations::Sensors result;
    for (const auto& [sensor, each] : told.at(name).items())
      result[sensor] = {each.at("unit").get<std::string>(), each.at("description").get<std::string>()};
    return result;
  };
  SceneCell result;
  result.cell.sensors = sensors("sensors");
  result.cell.figures = sensors("figures");
  result.cell.locations = told.at("locations").get<std::set<std::string>>();
  result.cell.unable = told.at("unable").get<std::map<std::string, std::string>>();
  for (const auto& [skill, codes] : told.at("longest").items())
    for (const auto& [code, text] : codes.items())
      if (auto formula = operations::Formula::parse(text.get<std::string>()))
        result.cell.longest.emplace(std::pair(skill, std::stoi(code)), std::move(*formula));
  result.skills = told.at("skills").get<std::string>();
  result.environment = told.at("environment").get<std::string>();
  for (const nlohmann::json& each : told.at("further")) {
    const std::string folder = each.at("from").get<std::string>() + "/";
    BuiltSkill& skill = result.further.emplace_back();
    skill.name = each.at("skill").get<std::string>();
    skill.pal = folder + each.at("pal").get<std::string>();
    skill.environment = folder + each.at("environment").get<std::string>();
    for (const auto& [name, text] : each.at("texts").items())
      skill.texts[folder + name] = text.get<std::string>();
  }
  return result;
}

}  // namespace

std::optional<SceneCell> cell_of_scene(const std::string& scene, const std::vector<std::string>& built,
                                       std::string& problem) {
  std::vector<std::string> words{"list", "--cell", scene};
  for (const std::string& file : built) {
    words.emplace_back("--skills");
    words.push_back(file);
  }
  const Spoken spoken = run_and_read(workcell_program(), words);
  if (spoken.status < 0 || spoken.status == 127) {
    problem = "there is no program 'workcell' beside this one or on the PATH, which knows the scenes";
    return std::nullopt;
  }
  if (spoken.status != 0) {
    problem = built.empty() ? "workcell does not know the scene"
                            : "workcell does not know the scene, or cannot read a skill";
    return std::nullopt;
  }
  try {
    return cell_of(nlohmann::json::parse(spoken.out));
  } catch (const nlohmann::json::exception&) {
    problem = "the program 'workcell' is of another version";
    return std::nullopt;
  }
}

}  // namespace pal::program
