// pal resources: what a skill needs, and what the workcell lacks.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <vector>

#include "pal/check/resources.hpp"
#include "programs/pal/commands/commands.hpp"

namespace pal::program {
namespace {

using check::Resource;

/// The needs of a skill, or of an operation of several, and by environment what it has not.
struct Comparison {
  std::vector<std::string> skills;
  std::vector<Resource> needed;
  std::vector<std::vector<Resource>> missing;  // by environment
};

bool contains(const std::vector<Resource>& resources, const Resource& resource) {
  return std::any_of(resources.begin(), resources.end(), [&](const Resource& other) {
    return other.group == resource.group && other.kind == resource.kind && other.name == resource.name &&
           other.module == resource.module;
  });
}

void write_table(const Comparison& comparison, const std::vector<pan::Environment>& environments,
                 std::ostream& out) {
  const auto& skills = comparison.skills;
  out << (skills.size() == 1 ? fmt::format("skill {} needs\n", skills.front())
                             : fmt::format("an operation of {} needs\n", fmt::join(skills, ", ")));
  const auto module_of = [](const Resource& resource) {
    return resource.name == resource.module ? "" : "of " + resource.module;
  };
  std::size_t widest = 0;
  std::size_t widest_module = 0;
  for (const Resource& resource : comparison.needed) {
    widest = std::max(widest, resource.name.size());
    widest_module = std::max(widest_module, module_of(resource).size());
  }
  std::string group;
  for (const Resource& resource : comparison.needed) {
    if (const auto here = check::group_text(resource.group); here != group) {
      out << "  " << here << "\n";
      group = here;
    }
    std::string line = fmt::format("    {:<{}}  {:<{}}  {:<20}", resource.name, widest, module_of(resource),
                                   widest_module, check::kind_text(resource.kind));
    for (std::size_t i = 0; i < environments.size(); ++i) {
      line += fmt::format("  {}: {}", environments[i].name,
                          contains(comparison.missing[i], resource) ? "MISSING" : "there");
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << "\n";
  }
  for (std::size_t i = 0; i < environments.size(); ++i) {
    const auto count = comparison.missing[i].size();
    out << (count == 0 ? fmt::format("environment {} has all of it\n", environments[i].name)
                       : fmt::format("environment {} lacks {} of {}\n", environments[i].name, count,
                                     comparison.needed.size()));
  }
}

nlohmann::json json(const Resource& resource) {
  static constexpr const char* kinds[] = {"processor", "device", "time", "listed"};
  return {{"group", check::group_text(resource.group)},
          {"kind", kinds[static_cast<std::size_t>(resource.kind)]},
          {"name", resource.name},
          {"module", resource.module}};
}

nlohmann::json json(const std::vector<Resource>& resources) {
  auto result = nlohmann::json::array();
  for (const Resource& resource : resources) result.push_back(json(resource));
  return result;
}

nlohmann::json json(const Comparison& comparison, const std::vector<pan::Environment>& environments) {
  auto compared = nlohmann::json::array();
  for (std::size_t i = 0; i < environments.size(); ++i) {
    compared.push_back({{"environment", environments[i].name}, {"missing", json(comparison.missing[i])}});
  }
  nlohmann::json result = {{"needs", json(comparison.needed)}, {"environments", compared}};
  if (comparison.skills.size() == 1) {
    result["skill"] = comparison.skills.front();
  } else {
    result["operation"] = comparison.skills;
  }
  return result;
}

/// Of each skill, and of all together if there are several: the operation that they make up (thesis,
/// section 2.3.4).
std::vector<Comparison> comparisons(const std::vector<pan::Network>& skills) {
  std::vector<Comparison> result;
  std::vector<std::string> names;
  for (const pan::Network& skill : skills) {
    names.push_back(skill.skill.name);
    result.push_back({{names.back()}, check::needed_resources(skill), {}});
  }
  if (skills.size() > 1) result.push_back({names, check::needed_resources(skills), {}});
  return result;
}

}  // namespace

ExitStatus show_resources(const ResourcesOptions& options, const Console& console) {
  Session session;
  const bool chosen = read(options.selection, console, session);
  show_findings(session, console);
  if (!chosen) return ExitStatus::usage;
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  const auto& environments = session.specification.environments;
  bool all = true;
  auto document = nlohmann::json::array();
  for (Comparison& comparison : comparisons(session.specification.skills)) {
    for (const pan::Environment& environment : environments) {
      comparison.missing.push_back(check::missing_resources(comparison.needed, environment));
      all = all && comparison.missing.back().empty();
    }
    if (options.format == Format::json) {
      document.push_back(json(comparison, environments));
    } else {
      write_table(comparison, environments, console.out);
    }
  }
  if (options.format == Format::json)
    console.out << document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  return all ? ExitStatus::all_hold : ExitStatus::wrong_specification;
}

}  // namespace pal::program
