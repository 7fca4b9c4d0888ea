// pal simulate: random runs, and what they show.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <ostream>
#include <sstream>

#include "analyzer/chart/chart.hpp"
#include "pal/support/duration_text.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/chart_caption.hpp"
#include "programs/pal/reports/simulated.hpp"
#include "programs/pal/reports/witness.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/runs.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

using analyzer::run_checker::FiledWitness;

analyzer::SimulationOptions simulation_of(const SimulateOptions& options, const std::function<bool()>& stop) {
  analyzer::SimulationOptions made;
  made.times = options.times;
  made.seed = options.seed;
  made.until = options.until.count();
  made.stop = stop;
  return made;
}

std::string how(const SimulateOptions& options) {
  if (!options.script.empty()) return "by script";
  using Times = analyzer::SimulationOptions::Times;
  const char* times = options.times == Times::random  ? "random"
                      : options.times == Times::worst ? "worst"
                      : options.times == Times::best  ? "best"
                                                      : "extreme";
  return fmt::format("{} times, seeds {} to {}, each of at most {}", times, options.seed,
                     options.seed + options.runs - 1, to_text(options.until));
}

/// A skill in an environment with all its runs, which can be made again.
struct Study {
  Simulated simulated;
  std::vector<FiledWitness> witnesses;  // by script: those of this skill and environment
  Runs runs;
};

/// Why a run by script is not what its witness claims; empty: it is.
std::string refusal_of(FiledWitness witness, const std::optional<KnownRun>& run, Session& session) {
  if (!witness.placement.empty()) return "it has its threads elsewhere; pal replay confirms it";
  if (!run) return "its script cannot be followed";
  witness.run = run->trace;
  return refusal(witness, session);
}

/// A run that is not whole when it is time to stop is not looked at: what is said is of whole runs.
void survey(Study& study, Session& session, const std::function<bool()>& stop) {
  Simulated& simulated = study.simulated;
  simulated.run_names = study.runs.names;
  simulated.asked = study.runs.names.size();
  Survey survey(simulated.problem);
  for (std::size_t number = 0; number < simulated.asked; ++number) {
    const auto run = study.runs.make(number);
    if (stop() || (run && !survey.add(*run, number, stop))) break;
    ++simulated.runs;
    if (!study.witnesses.empty()) {
      const std::string why = refusal_of(study.witnesses[number], run, session);
      if (!why.empty()) simulated.refused.push_back(study.runs.names[number] + ": " + why);
    }
  }
  simulated.completed = survey.completed();
  simulated.seen = survey.seen();
  for (const std::string& refused : survey.refused()) simulated.refused.push_back(refused);
}

/// The studies stay where they are: runs point into them.
std::vector<std::unique_ptr<Study>> studies_of(const SimulateOptions& options,
                                               const std::vector<FiledWitness>& witnesses, Session& session,
                                               const std::function<bool()>& stop) {
  std::vector<std::unique_ptr<Study>> studies;
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      auto problem = problem_of(skill, environment, session);
      if (!problem) continue;
      auto study = std::make_unique<Study>();
      study->simulated.problem = std::move(*problem);
      study->simulated.how = how(options);
      for (const FiledWitness& witness : witnesses) {
        if (witness.skill == skill.skill.name && witness.environment == environment.name)
          study->witnesses.push_back(witness);
      }
      if (!options.script.empty() && study->witnesses.empty()) continue;
      const analyzer::Problem& known = study->simulated.problem;
      study->runs = options.script.empty() ? runs_by_chance(known, simulation_of(options, stop), options.runs)
                                           : scripted_runs(known, study->witnesses);
      studies.push_back(std::move(study));
    }
  }
  return studies;
}

/// The study and the requirement whose run is to be written; says why there is none.
std::optional<std::pair<const Study*, std::size_t>> choose(const std::vector<std::unique_ptr<Study>>& studies,
                                                           const std::string& name, std::ostream& err) {
  for (const auto& study : studies) {
    const Simulated& simulated = study->simulated;
    if (name.empty()) {
      const auto best = most_interesting(simulated.problem, simulated.seen);
      if (best) return std::pair(study.get(), *best);
      continue;
    }
    for (std::size_t r = 0; r < simulated.seen.size(); ++r) {
      if (simulated.problem.requirements[r].name == name && simulated.seen[r].extreme)
        return std::pair(study.get(), r);
    }
  }
  err << (name.empty() ? "pal: no run shows a requirement's value, so there is none to write\n"
                       : fmt::format("pal: no run shows a value of '{}', so there is none to write\n", name));
  return std::nullopt;
}

std::string chart_of(const Study& study, std::size_t index, const KnownRun& run) {
  const Seen& seen = study.simulated.seen[index];
  const analyzer::Problem& problem = study.simulated.problem;
  const analyzer::Requirement& requirement = problem.requirements[index];
  analyzer::chart::ChartOptions options;
  options.caption.requirement = requirement.name;
  options.caption.measure = measure_text(problem, index) + "; " + study.runs.names[seen.run];
  options.caption.verdict = seen.breaking > 0 ? "broken" : seen.open > 0 ? "open" : "kept";
  options.caption.figures = shown_figures(requirement, Duration(seen.extreme->value));
  const std::string label = short_measure_text(problem, index);
  if (!label.empty() && seen.extreme->value > 0) {
    const bool over = requirement.allowed().broken_by(seen.extreme->value);
    options.highlight =
        analyzer::chart::Highlight{seen.extreme->born, seen.extreme->at, label, over, requirement.limit};
  }
  return analyzer::chart::svg(analyzer::chart::timeline(run.trace), options);
}

ExitStatus write_run(const SimulateOptions& options, const std::pair<const Study*, std::size_t>& chosen,
                     const std::vector<std::string>& inputs, const Console& console) {
  const auto& [study, index] = chosen;
  const auto run = study->runs.make(study->simulated.seen[index].run);
  std::vector<OutputFile> files;
  if (!options.trace.empty()) {
    std::ostringstream text;
    options.chrome ? trace::write_chrome(run->trace, text) : trace::write_json(run->trace, text);
    files.push_back({options.trace, text.str()});
  }
  if (!options.chart.empty()) files.push_back({options.chart, chart_of(*study, index, *run)});
  return write_and_list(files, inputs, console);
}

/// Nothing, if some skill has a requirement of that name; else what there is.
std::string unknown_requirement(const std::string& name, const std::vector<std::unique_ptr<Study>>& studies) {
  std::string known;
  for (const auto& study : studies) {
    for (const analyzer::Requirement& each : study->simulated.problem.requirements) {
      if (each.name == name) return {};
      known += " '" + each.name + "'";
    }
  }
  return "no requirement is called '" + name + "'; there is" + (known.empty() ? " none" : known);
}

/// Nothing, if it can be simulated; else why not.
std::string obstacle(const SimulateOptions& options, const Session& session,
                     const std::vector<std::unique_ptr<Study>>& studies) {
  if (session.specification.environments.empty())
    return "a simulation needs times: give an environment with --environment FILE";
  for (const auto& study : studies) {
    if (!analyzer::fits_simulation(study->simulated.problem))
      return "'" + study->simulated.problem.skill +
             "' is too large to simulate (more than 2000 threads or 4000 channels, or a device with more "
             "than 128 requests)";
  }
  if (studies.empty()) {
    return options.script.empty() ? "there is no skill to simulate"
                                  : "'" + options.script + "' has no run of these skills";
  }
  if (!options.requirement.empty()) return unknown_requirement(options.requirement, studies);
  return {};
}

}  // namespace

ExitStatus simulate(const SimulateOptions& options, const Console& console) {
  std::optional<std::vector<FiledWitness>> witnesses{std::in_place};
  if (!options.script.empty()) witnesses = read_witness_file(options.script, console);
  if (!witnesses) return ExitStatus::usage;
  const Interruption interruption;
  const std::function<bool()> late = end_after(options.seconds);
  bool writes = false;  // a run that is to be written is made again, and whole
  const auto stop = [&] { return !writes && late(); };
  Session session;
  session.stop = end_after(options.seconds / 2);
  if (!read(options.selection, console, session)) return ExitStatus::usage;
  std::vector<std::string> inputs = inputs_of(session);
  if (!options.script.empty()) inputs.push_back(options.script);
  if (!may_write({options.trace, options.chart}, inputs, console)) return ExitStatus::usage;
  std::vector<std::unique_ptr<Study>> studies;
  if (!session.diagnostics.has_errors()) studies = studies_of(options, *witnesses, session, stop);
  const ExitStatus found = status_of_findings(session);
  bool good = true;
  for (const auto& study : studies) {
    if (found == ExitStatus::all_hold) good = !look_for_zeno_run(study->simulated.problem, session) && good;
  }
  show_findings(session, console);
  if (found != ExitStatus::all_hold) return found;
  const std::string wrong = obstacle(options, session, studies);
  if (!wrong.empty()) {
    console.err << "pal: " << wrong << "\n";
    return ExitStatus::usage;
  }
  std::vector<Simulated> simulations;
  for (const auto& study : studies) {
    survey(*study, session, stop);
    const Simulated& simulated = study->simulated;
    good = good && simulated.runs == simulated.asked && simulated.refused.empty() &&
           std::all_of(simulated.seen.begin(), simulated.seen.end(),
                       [](const Seen& seen) { return seen.breaking == 0 && seen.open == 0; });
  }
  const bool early = stop();
  for (const auto& study : studies) {
    if (options.format == Format::text) console.out << text(study->simulated);
    simulations.push_back(study->simulated);
  }
  if (options.format == Format::json) console.out << json(simulations);
  if (!options.trace.empty() || !options.chart.empty()) {
    writes = true;
    const auto chosen = choose(studies, options.requirement, console.err);
    if (!chosen) return early ? ExitStatus::not_met : ExitStatus::usage;
    const ExitStatus written = write_run(options, *chosen, inputs, console);
    if (written != ExitStatus::all_hold) return written;
  }
  return good ? ExitStatus::all_hold : ExitStatus::not_met;
}

}  // namespace pal::program
