// pal whatif: slacks, remedies, placements.
#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>
#include <sstream>

#include "analyzer/runs/growing_loop.hpp"
#include "pal/pan/times.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/slack_display.hpp"
#include "programs/pal/reports/whatif_answer.hpp"
#include "programs/pal/reports/witness.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

using State = analyzer::VerdictState;

/// Whether another of the skills brings the figure that the change is about.
bool is_of_another(const std::vector<pan::Network>& skills, pan::Environment environment,
                   const std::string& change) {
  for (const pan::Network& each : skills) environment = pan::with_times_of(each, std::move(environment));
  return analyzer::whatif::change(environment, change).empty();
}

/// The environment as the skill meets it, with the changes. Nothing, and what is wrong on `err`, if they
/// cannot be made.
std::optional<pan::Environment> changed(const pan::Network& skill, const pan::Environment& environment,
                                        const std::vector<pan::Network>& skills,
                                        const std::vector<std::string>& changes, std::ostream& err) {
  pan::Environment made = pan::with_times_of(skill, environment);
  for (const std::string& each : changes) {
    const std::string wrong = analyzer::whatif::change(made, each);
    if (wrong.empty() || is_of_another(skills, made, each)) continue;
    err << "pal: " << wrong << "\n";
    return std::nullopt;
  }
  return made;
}

class Question {
 public:
  Question(const WhatIfOptions& options, Session& session, const analyzer::Options& analysis,
           const Console& console)
      : options_(options), session_(session), analysis_(analysis), console_(console) {}

  /// False: the changes are wrong.
  bool answer(const pan::Network& skill, const pan::Environment& environment, WhatIfAnswer& answer) {
    auto problem = problem_of(skill, environment, session_);
    if (!problem || session_.diagnostics.has_errors()) return true;
    answer.skill = problem->skill;
    answer.environment = problem->environment;
    for (const auto& requirement : problem->requirements) answer.requirements.push_back(requirement.name);
    const auto other =
        changed(skill, environment, session_.specification.skills, options_.changes, console_.err);
    if (!other) return false;
    if (!options_.changes.empty() && !compare(skill, *other, std::move(*problem), answer)) return true;
    if (options_.place) place(skill, *other, answer);
    if (options_.changes.empty() && !options_.place) {
      look_for_slack(skill, environment, answer);
      if (!good(answer)) look_for_remedies(skill, environment, answer);
    }
    return true;
  }

 private:
  void look_for_slack(const pan::Network& skill, const pan::Environment& environment, WhatIfAnswer& answer) {
    if (!console_.terminal || options_.format == Format::json) {
      answer.slacks = analyzer::whatif::slacks(skill, environment, analysis_);
      return;
    }
    SlackDisplay display(skill, environment, answer, console_.out);
    answer.slacks = analyzer::whatif::slacks(skill, environment, analysis_, display.observer());
    display.finish();
  }

  void look_for_remedies(const pan::Network& skill, const pan::Environment& environment,
                         WhatIfAnswer& answer) {
    ProgramChanges programs(options_.selection, skill, phases_for(skill, environment), console_.files);
    answer.remedies = analyzer::whatif::find_remedies(
        skill, environment, programs.all().size(),
        [&programs](const std::vector<analyzer::whatif::ProgramChangeId>& made) {
          return programs.network_with(made);
        },
        analysis_);
    answer.program_changes = programs.all();
  }

  /// Of what grows with each turn of a loop: the phase that leaves the loop out.
  std::map<std::string, std::string> phases_for(const pan::Network& skill,
                                                const pan::Environment& environment) const {
    std::map<std::string, std::string> phases;
    Diagnostics ignored;
    const auto problem = analyzer::make_problem(skill, environment, ignored);
    for (std::size_t r = 0; problem && r < problem->requirements.size(); ++r) {
      const analyzer::Requirement& requirement = problem->requirements[r];
      const auto growing = analyzer::find_growing_loop(*problem, requirement, analysis_.stop);
      if (!growing) continue;
      std::string phase = analyzer::phase_without(*problem, requirement, growing->loop, analysis_.stop);
      if (!phase.empty()) phases[requirement.name] = std::move(phase);
    }
    return phases;
  }

  bool compare(const pan::Network& skill, const pan::Environment& other, analyzer::Problem before,
               WhatIfAnswer& answer) {
    auto after = analyzer::make_problem(skill, other, session_.diagnostics, &session_.sources);
    if (!after) return false;
    for (analyzer::Problem* problem : {&before, &*after}) {
      analyzer::Analysis analysis =
          analyzer::analyze(*problem, analyzer::AnalysisChoice::automatic, analysis_);
      answer.before_and_after.push_back({std::move(*problem), std::move(analysis)});
    }
    return true;
  }

  void place(const pan::Network& skill, const pan::Environment& environment, WhatIfAnswer& answer) {
    analyzer::whatif::RequirementChecker checker(skill, analysis_);
    analyzer::whatif::PlacementOptions how;
    how.priorities = options_.priorities;
    answer.fewest = *options_.place == 0;
    answer.priorities = options_.priorities;
    if (answer.fewest) {
      answer.placements = analyzer::whatif::fewest_processors(environment, checker, how);
    } else {
      answer.placements = {analyzer::whatif::placements_on(*options_.place, environment, checker, how)};
    }
    if (!options_.witness.empty())
      answer.witnesses = filed_witnesses_of(answer.placements, skill, environment, analysis_);
  }

  const WhatIfOptions& options_;
  Session& session_;
  const analyzer::Options& analysis_;
  const Console& console_;
};

/// With the figures as they are asked for: no verdict says `holds` where time stands still.
void look_for_zeno_runs(const std::vector<std::string>& changes, Session& session) {
  std::ostringstream known;
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      Diagnostics ignored;
      const auto other = changed(skill, environment, session.specification.skills, changes, known);
      const auto problem = other ? analyzer::make_problem(skill, *other, ignored) : std::nullopt;
      if (problem) look_for_zeno_run(*problem, session);
    }
  }
}

/// `listed`: says on the standard output where they are; what is JSON there stays JSON.
/// There may be much to write: it is taken out of the answers.
ExitStatus write_witnesses(std::vector<WhatIfAnswer>& answers, const std::string& path, bool listed,
                           const Session& session, const Console& console) {
  std::vector<std::string> all;
  std::size_t refuted = 0;
  for (WhatIfAnswer& answer : answers) {
    std::move(answer.witnesses.begin(), answer.witnesses.end(), std::back_inserter(all));
    for (const analyzer::whatif::Placements& on : answer.placements) refuted += on.refuted.size();
  }
  if (all.size() < refuted) {
    console.err << "pal: of " << refuted - all.size() << " of " << refuted
                << " placements refuted no run is found again within the limits\n";
  }
  std::vector<OutputFile> files(1);
  files.front() = {path, analyzer::run_checker::file_of(all)};
  if (listed) return write_and_list(files, inputs_of(session), console);
  const auto problem = write_files(files);
  if (problem) console.err << "pal: " << *problem << "\n";
  return problem ? ExitStatus::usage : ExitStatus::all_hold;
}

}  // namespace

bool good(const WhatIfAnswer& answer) {
  const bool slack = std::all_of(answer.slacks.begin(), answer.slacks.end(),
                                 [](const auto& each) { return each.holds.has_value(); });
  const bool after = answer.before_and_after.empty() || all_hold({answer.before_and_after.back()});
  const bool placed = answer.placements.empty() || !answer.placements.back().meet.empty();
  return slack && after && placed;
}

ExitStatus what_if(const WhatIfOptions& options, const Console& console) {
  Session session;
  const Interruption interruption;  // till all is written
  const bool is_slack = options.changes.empty() && !options.place;
  const bool limited = options.limits.seconds >= 0;
  ProofLimits limits = options.limits;
  if (!limited) limits.seconds = is_slack ? usual_seconds_of_slack : 0;
  limit_checks(limits, session);
  if (!read(options.selection, console, session)) return ExitStatus::usage;
  if (!may_write({options.witness}, inputs_of(session), console)) return ExitStatus::usage;
  if (!session.diagnostics.has_errors() && session.specification.environments.empty()) {
    console.err << "pal: what if needs times: give an environment with --environment FILE\n";
    return ExitStatus::usage;
  }
  const analyzer::Options analysis = options_of(limits);
  std::vector<WhatIfAnswer> answers;
  bool sound_changes = true;
  if (!session.diagnostics.has_errors()) {
    Question question(options, session, analysis, console);
    for (const pan::Network& skill : session.specification.skills) {
      for (const pan::Environment& environment : session.specification.environments) {
        WhatIfAnswer& answer = answers.emplace_back();
        sound_changes = sound_changes && question.answer(skill, environment, answer);
      }
    }
  }
  const ExitStatus found = status_of_findings(session);
  if (found == ExitStatus::all_hold && sound_changes) look_for_zeno_runs(options.changes, session);
  show_findings(session, console);
  if (!sound_changes) return ExitStatus::usage;
  if (found != ExitStatus::all_hold) return found;
  if (options.format == Format::json) {
    console.out << json(answers);
  } else {
    for (const WhatIfAnswer& answer : answers) console.out << text(answer);
  }
  if (!options.witness.empty()) {
    const bool listed = options.format != Format::json;
    const ExitStatus written = write_witnesses(answers, options.witness, listed, session, console);
    if (written != ExitStatus::all_hold) return written;
  }
  // What the end of the time left open was not answered; of changed figures the verdicts say what was. The
  // usual time of slack is no limit that the user asked for.
  const bool ended = Interruption::asked_for() || (limited && analysis.stop && analysis.stop());
  const bool unanswered = ended && options.changes.empty();
  return !unanswered && std::all_of(answers.begin(), answers.end(), good) ? ExitStatus::all_hold
                                                                          : ExitStatus::not_met;
}

}  // namespace pal::program
