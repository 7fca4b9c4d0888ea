#include "tests/run/skills/support/workshop.hpp"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

#include "sim/picture/body_pose.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/support/built_skills.hpp"

namespace pal::test {

namespace {

constexpr runtime::Time rest = std::chrono::milliseconds(300);
constexpr double shoulder = 671.8;  // mm above the floor

sim::CellOptions seeded(std::uint64_t seed) {
  sim::CellOptions options;
  options.seed = seed;
  return options;
}

}  // namespace

ChangedScene::ChangedScene(const std::string& name, const std::string& lines) {
  std::string folder = (std::filesystem::temp_directory_path() / "pal-scene-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no folder " + folder);
  folder_ = folder;
  const sim::Scene original = test::scene(name);
  const std::filesystem::path models = PAL_SOURCE_DIR "/sim/scenes";
  for (const char* part : {"puma560.xml", "cell.xml"})
    std::filesystem::copy_file(models / part, folder_ / part);
  scene_ = {name, folder_ / (name + ".scene")};
  std::ofstream out(scene_.file);
  out << std::ifstream(original.file).rdbuf() << '\n' << lines << '\n';
}

ChangedScene::~ChangedScene() {
  std::filesystem::remove_all(folder_);
}

Workshop::Workshop(const sim::Scene& scene, std::uint64_t seed) : Workshop(scene, seeded(seed)) {}

Workshop::Workshop(const sim::Scene& scene, const sim::CellOptions& options) : cell_(scene, options) {
  const std::vector<std::string> names = sim::scene_geometry(cell_.workcell()).bodies;
  for (std::size_t i = 1; i < names.size(); ++i) bodies_[names[i]] = i - 1;
}

runtime::Outcome Workshop::run(const std::string& name,
                               const std::vector<runtime::ParameterValue>& parameters) {
  const auto skill = test::make_skill(name);
  if (!skill) throw std::runtime_error("there is no skill " + name);
  begun_ = cell_.workcell().log().size();
  runtime::Outcome outcome = cell_.run(*skill, parameters);
  cell_.rest(rest);
  return outcome;
}

runtime::Outcome Workshop::run(const std::string& name,
                               const std::vector<runtime::ParameterValue>& parameters, ProvedBounds& bounds) {
  runtime::Outcome outcome = run(name, parameters);
  bounds.observe(outcome.trace);
  return outcome;
}

Eigen::Vector3d Workshop::middle(const std::string& thing) {
  const auto& at = sim::body_poses(cell_.workcell()).at(bodies_.at(thing)).position;
  return 1e3 * Eigen::Vector3d(at[0], at[1], at[2]) - Eigen::Vector3d(0, 0, shoulder);
}

std::map<std::string, Eigen::Vector3d> Workshop::parts() {
  std::map<std::string, Eigen::Vector3d> result;
  for (const auto& [name, index] : bodies_)
    if (name.starts_with("part")) result[name] = middle(name);
  return result;
}

std::span<const sim::Sample> Workshop::log() {
  return std::span(cell_.workcell().log()).subspan(begun_);
}

}  // namespace pal::test
