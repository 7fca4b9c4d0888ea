#include "programs/workcell/session/skill_pictures.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "analyzer/chart/chart.hpp"
#include "pal/pan/dot.hpp"
#include "programs/pal/reports/proof_chart.hpp"

namespace pal::workcell {
namespace {

/// As files of a page may be called.
std::string plain(const std::string& name) {
  std::string result;
  for (const char each : name)
    result += std::isalnum(static_cast<unsigned char>(each)) != 0 || each == '-' ? each : '_';
  return result;
}

}  // namespace

SkillPictures::SkillPictures() {
  std::string name = (std::filesystem::temp_directory_path() / "pal-pictures-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": it cannot be made");
  folder_ = name;
}

SkillPictures::~SkillPictures() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void SkillPictures::add(const std::string& skill, const std::string& name, const std::string& title,
                        const std::string& svg, Pictures& pictures) const {
  const std::string below = fmt::format("skills/{}", plain(skill));
  std::error_code problem;
  std::filesystem::create_directories(folder_ + "/" + below, problem);
  const std::string path = fmt::format("{}/{}.svg", below, plain(name));
  std::ofstream out(folder_ + "/" + path, std::ios::binary);
  out << svg;
  out.close();
  if (out) pictures.push_back({title, "/files/" + path});
}

void SkillPictures::draw_modules(const pan::Network& network, Pictures& pictures) const {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::Module& module = network.modules[i];
    if (module.body.empty()) continue;
    try {
      add(network.skill.name, "pan-" + module.name, fmt::format("{} as a graph", module.name),
          pan::svg(pan::to_dot(network, pan::ModuleId(i), {})), pictures);
    } catch (const std::exception&) {
      continue;  // Graphviz could not
    }
  }
}

void SkillPictures::draw_runs(const program::Proof& proof, Pictures& pictures) const {
  for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i) {
    const auto shown = program::shown_run(proof, i);
    if (!shown) continue;
    const std::string& requirement = proof.problem.requirements[i].name;
    add(proof.problem.skill, "run-" + requirement, fmt::format("{}: {}", requirement, shown->name),
        analyzer::chart::svg(analyzer::chart::timeline(shown->run), shown->options), pictures);
  }
}

}  // namespace pal::workcell
