// pal operation check and format.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "operations/load.hpp"
#include "operations/ways.hpp"
#include "pal/check/resources.hpp"
#include "pal/support/duration_text.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/commands/operation_files.hpp"
#include "programs/pal/reports/check_report.hpp"
#include "programs/pal/reports/sarif.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/scene_cell.hpp"
#include "programs/pal/session/unchecked.hpp"

namespace pal::program {
namespace {

using operations::Program;
using operations::Ways;

/// The bounds of DURATION requirements. Of several environments the greatest.
operations::ProvedTimes times_of(const Session& session, const std::vector<Proof>& proofs) {
  operations::ProvedTimes times;
  for (const pan::Network& network : session.specification.skills) {
    for (const pan::Requirement& requirement : network.requirements) {
      const auto* completing = std::get_if<pan::Completing>(&requirement.measure);
      if (completing == nullptr) continue;
      for (const Proof& proof : proofs) {
        if (proof.problem.skill != network.skill.name) continue;
        for (const analyzer::Verdict& verdict : proof.analysis.verdicts) {
          if (verdict.requirement != requirement.name || !verdict.bound) continue;
          Duration& time = times[{network.skill.name, completing->code}];
          time = std::max(time, *verdict.bound);
        }
      }
    }
  }
  return times;
}

void write_ways(const Program& program, const Ways& ways, std::ostream& out) {
  out << fmt::format("operation {}: {} way{}{}\n", program.operations.front().name, ways.ways.size(),
                     ways.ways.size() == 1 ? "" : "s", ways.complete ? "" : ", and more");
  for (const operations::WayThrough& way : ways.ways) {
    out << fmt::format("  {}{}{}{}\n", fmt::join(way.icons, " -> "), way.icons.empty() ? "" : ", ", way.end,
                       way.alike == 1 ? "" : fmt::format(" ({} ways)", way.alike));
    out << fmt::format("    longest {}{}; shortest: at least {}\n",
                       way.longest ? to_text(*way.longest) : std::string("not known"),
                       way.longest && way.declared ? " (declared, not proved)" : "", to_text(way.shortest));
    if (!way.unbounded.empty())
      out << fmt::format("    no DURATION is proved or declared of {}\n", fmt::join(way.unbounded, ", "));
  }
}

nlohmann::ordered_json json(const Program& program, const Ways& ways) {
  auto list = nlohmann::ordered_json::array();
  for (const operations::WayThrough& way : ways.ways) {
    nlohmann::ordered_json each;
    each["icons"] = way.icons;
    each["end"] = way.end;
    each["shortest_ns"] = way.shortest.count();
    each["longest_ns"] = nullptr;
    if (way.longest) each["longest_ns"] = way.longest->count();
    each["unbounded"] = way.unbounded;
    each["declared"] = way.declared;
    each["alike"] = way.alike;
    list.push_back(std::move(each));
  }
  return {{"name", program.operations.front().name}, {"complete", ways.complete}, {"ways", list}};
}

operations::Sensors named(const std::vector<std::string>& names) {
  operations::Sensors result;
  for (const std::string& name : names) result[name];
  return result;
}

/// What the options say of the cell. They do not know units.
operations::Cell cell_of(const OperationOptions& options) {
  operations::Cell cell;
  if (!options.locations.empty()) cell.locations.emplace(options.locations.begin(), options.locations.end());
  if (!options.sensors.empty()) cell.sensors = named(options.sensors);
  if (!options.figures.empty()) cell.figures = named(options.figures);
  return cell;
}

void check_against_cell(const Session& session, const BuiltSkills& built, Diagnostics& diagnostics) {
  for (const pan::Network& skill : session.specification.skills)
    for (const pan::Environment& environment : session.specification.environments)
      if (built.runs_in(skill, environment, session)) check::check_listed(skill, environment, diagnostics);
}

std::vector<Program> read_programs(const OperationOptions& options, const Console& console, bool& whole,
                                   Session& session) {
  std::vector<Program> programs;
  for (const std::string& file : options.files) {
    auto program = operations::load(console.files, session.sources, file, session.diagnostics);
    if (!program) continue;
    if (!session.diagnostics.has_errors())
      whole = operations::check_shape(*program, session.diagnostics, session.stop) && whole;
    programs.push_back(std::move(*program));
  }
  return programs;
}

/// Findings in the object of an icon get its name, and that of its operation.
void name_icons(const std::vector<Program>& programs, const Session& session,
                nlohmann::ordered_json& document) {
  auto& findings = document["diagnostics"];
  const std::vector<Diagnostic> sorted = session.diagnostics.sorted();
  for (std::size_t i = 0; i < sorted.size() && i < findings.size(); ++i) {
    for (const Program& program : programs) {
      const auto extent = operations::extent_of(program, sorted[i].where);
      if (!extent) continue;
      findings[i]["operation"] = extent->operation;
      findings[i]["icon"] = extent->icon;
      break;
    }
  }
}

}  // namespace

ExitStatus check_operation(const OperationOptions& given, const Console& user) {
  OperationOptions options = given;
  operations::Cell cell = cell_of(options);
  const std::vector<std::string> built_files = take_built(options.skills);
  BuiltSkills built(user.files);
  if (!options.scene.empty()) {
    std::string problem;
    auto known = cell_of_scene(options.scene, built_files, problem);
    if (!known) {
      user.err << fmt::format("pal: --scene {}: {}\n", options.scene, problem);
      return ExitStatus::usage;
    }
    cell = std::move(known->cell);
    // The same skills in another folder are those that are meant.
    if (options.skills.empty()) options.skills = {known->skills};
    if (options.environments.empty()) options.environments = {known->environment};
    built.add(std::move(known->further), options.skills, options.environments);
  } else if (!built_files.empty()) {
    user.err << fmt::format("pal: --skills {}: only the workcell reads a built skill: name a scene, too "
                            "(--scene SCENE), or the skill's PAL\n",
                            built_files.front());
    return ExitStatus::usage;
  }
  const Console console{user.out, user.err, built, user.terminal, user.colour_out, user.colour_err};
  Session session;
  session.max_errors = options.max_errors;
  const Interruption interruption;  // till all is written
  options.limits.leaves_out = [&](const pan::Network& skill, const pan::Environment& environment) {
    return !built.runs_in(skill, environment, session);
  };
  limit_checks(options.limits, session);
  bool whole = true;  // false: --timeout or Ctrl-C ended it
  const std::vector<Program> programs = read_programs(options, console, whole, session);

  std::vector<Proof> proofs;
  std::vector<Ways> ways;
  const bool well_formed = !session.diagnostics.has_errors();
  if (well_formed && !options.skills.empty()) {
    std::set<std::string> used;
    for (const Program& program : programs) used.merge(operations::skills_of(program));
    cell.skills = read_skills(options, used, console, session, built);
  }
  if (well_formed)
    for (const Program& program : programs)
      whole = operations::check_cell(program, cell, session.diagnostics, session.stop) && whole;
  if (well_formed && cell.skills) {
    if (!session.diagnostics.has_errors()) check_against_cell(session, built, session.diagnostics);
    if (!session.diagnostics.has_errors()) proofs = prove(session, options.limits);
    if (!session.diagnostics.has_errors())
      for (const Program& program : programs)
        ways.push_back(
            operations::ways_through(program, *cell.skills, {times_of(session, proofs), cell.longest}));
  }
  const ExitStatus found = status_of_findings(session);
  const bool wrong = found != ExitStatus::all_hold;
  report_unmet(proofs, options.format != Format::text, session);
  const std::vector<Unchecked> not_checked =
      options.skills.empty() ? std::vector<Unchecked>()
                             : unchecked(session, proofs, wrong ? Unproved::wrong : Unproved::nowhere);
  const ExitStatus status = wrong                       ? found
                            : whole && all_hold(proofs) ? ExitStatus::all_hold
                                                        : ExitStatus::not_met;
  if (!whole) console.err << "pal: the checks of operations were ended early, so not all was checked\n";

  if (options.format == Format::sarif) {
    console.out << sarif(session, not_checked, false, has_verdicts(proofs), status);
  } else if (options.format == Format::json) {
    auto document = nlohmann::ordered_json::parse(json(proofs, not_checked, session));
    name_icons(programs, session, document);
    document["operations"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < ways.size(); ++i)
      document["operations"].push_back(json(programs[i], ways[i]));
    console.out << document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  } else {
    show_findings(session, console);
    if (!wrong && options.skills.empty())
      console.err
          << "pal: no skills, so their parameters and codes were not checked (give --skills FOLDER)\n";
    else if (!wrong && options.environments.empty())
      console.err << "pal: no environment, so no times were proved (give --environment FILE)\n";
    write_table(proofs, false, console.out);
    for (std::size_t i = 0; i < ways.size(); ++i) write_ways(programs[i], ways[i], console.out);
  }
  return status;
}

}  // namespace pal::program
