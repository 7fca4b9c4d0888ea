#include "programs/pal/session/scene_cell.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

extern char** environ;

namespace pal::program {
namespace {

struct Spoken {
  int status = -1;  // of its exit; negative: it did not run
  std::string out;
};

/// Runs it and waits for its end. What it says of errors goes where ours goes.
Spoken run_and_read(const std::string& program, std::vector<std::string> words) {
  Spoken result;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return result;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = -1;
  const int failed = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::array<char, 4096> piece{};
  for (ssize_t count = 0; failed == 0 && (count = ::read(ends[0], piece.data(), piece.size())) > 0;)
    result.out.append(piece.data(), static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  if (failed == 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status))
    result.status = WEXITSTATUS(status);
  return result;
}

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
  return result;
}

}  // namespace

std::optional<SceneCell> cell_of_scene(const std::string& scene, std::string& problem) {
  const Spoken spoken = run_and_read(workcell_program(), {"list", "--cell", scene});
  if (spoken.status < 0 || spoken.status == 127) {
    problem = "there is no program 'workcell' beside this one or on the PATH, which knows the scenes";
    return std::nullopt;
  }
  if (spoken.status != 0) {
    problem = "workcell does not know the scene";
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
