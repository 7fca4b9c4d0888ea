// Requirements that fail or are undecided, as findings.
#include <algorithm>
#include <filesystem>
#include <string>

#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/machine/loss_rows.hpp"
#include "analyzer/verdict/sentence.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/support/finding.hpp"
#include "programs/pal/session/measure_text.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {
namespace {

using Measure = analyzer::Requirement::Measure;
using State = analyzer::VerdictState;

SourceSpan place_of(const analyzer::Problem& problem, const analyzer::Reason& reason) {
  const auto found = std::find_if(
      problem.statements.begin(), problem.statements.end(),
      [&](const auto& statement) { return statement.line == reason.line && statement.file == reason.file; });
  return found == problem.statements.end() || reason.line == 0 ? SourceSpan{} : found->where;
}

/// "tap.pal:68".
std::string loop_place(const analyzer::Problem& problem, analyzer::LoopId loop) {
  const analyzer::ProgramLoop& of = problem.loops[loop];
  return of.line == 0 ? "REPEAT of " + problem.module_names[of.module]
                      : std::filesystem::path(of.file).filename().string() + ":" + std::to_string(of.line);
}

/// "is 35 ms".
std::string known_figure(const analyzer::Problem& problem, const analyzer::Verdict& verdict) {
  if (verdict.loop_growth) {
    const analyzer::LoopId loop = verdict.loop_growth->loop;
    return loop.valid()
               ? "grows with each turn of the loop at " + loop_place(problem, loop) + ", without bound"
               : "grows as long as the run goes on, without bound";
  }
  if (!verdict.bound) {
    const auto shown = worth_telling(verdict);
    if (shown)
      return (verdict.at_least ? "is at most " : "is at least ") + text(figure_of(verdict.measure, *shown));
    return verdict.state == State::undecided ? "has no bound that was found" : "is without bound";
  }
  const auto shown = attained(verdict);
  if (verdict.state == State::fails && shown && *shown != *verdict.bound) {
    return "is between " + text(figure_of(verdict.measure, std::min(*shown, *verdict.bound))) + " and " +
           text(figure_of(verdict.measure, std::max(*shown, *verdict.bound)));
  }
  const std::string sound = verdict.at_least ? "at least " : "at most ";
  return "is " + (verdict.state == State::undecided ? sound : "") +
         text(figure_of(verdict.measure, *verdict.bound));
}

/// The longest piece of the time in which the thread that decided, the last of the story, did nothing but
/// wait after it had read.
const analyzer::Reason* longest_wait_after_read(const analyzer::Verdict& verdict) {
  const analyzer::Reason* longest = nullptr;
  for (std::size_t i = 1; i < verdict.reasons.size(); ++i) {
    const analyzer::Reason& reason = verdict.reasons[i];
    if (reason.actor != verdict.reasons.back().actor || !reason.waits()) continue;
    if (longest == nullptr || reason.to - reason.from > longest->to - longest->from) longest = &reason;
  }
  return longest;
}

/// The wait that most of the time goes to between a set and a read by one thread; null: it is something else.
const analyzer::Reason* wait_between_set_and_read(const analyzer::Verdict& verdict) {
  if (verdict.reasons.empty()) return nullptr;
  const analyzer::Reason& set = verdict.reasons.front();
  const auto longest =
      std::max_element(set.inside.begin(), set.inside.end(),
                       [](const auto& a, const auto& b) { return a.to - a.from < b.to - b.from; });
  const bool waits = longest != set.inside.end() && longest->actor == set.actor &&
                     set.actor == verdict.reasons.back().actor &&
                     longest->kind == analyzer::Reason::Kind::waits_for_message;
  return waits ? &*longest : nullptr;
}

/// What may decide a requirement that is undecided.
std::string hint_of_undecided(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  const int row = proof.problem.requirements[index].in;
  if (proof.analysis.zeno_run) return "give something in the loop a time";
  if (proof.ended_by_user) return "ended by you; let the proof go on, or limit it with --timeout";
  if (verdict.measure == Measure::loss && row > analyzer::longest_followed_row)
    return "a row of more than " + std::to_string(analyzer::longest_followed_row) +
           " is only bounded by shorter ones: require what these show, or a shorter row";
  if (proof.explored)
    return "allow more with --max-states, --max-memory or --timeout, or make the skill or its times simpler";
  if (analyzer::fits_exploration(proof.problem)) return "ask the exact analysis too, with --analysis auto";
  if (!verdict.bound) return "change what the note names: without it there may be a bound";
  return verdict.at_least ? "keep the passes further apart, so that the bound reaches what is required"
                          : "shorten what is done on the way, or give it a processor of its own, until the "
                            "bound is as required";
}

/// How to end the growth, or to leave it out.
std::string hint_of_growth(const analyzer::Verdict& verdict) {
  const analyzer::LoopGrowth& growth = *verdict.loop_growth;
  if (verdict.measure == Measure::duration)
    return "let the loop end after so many turns, or so much time: WTM … WITHIN";
  const std::string loop = growth.loop.valid() ? " in the loop" : "";
  const std::string renew = verdict.measure == Measure::age || verdict.measure == Measure::reaction
                                ? "get a new value" + loop
                                : "let it come about" + loop;
  if (growth.phase.empty()) return renew + ", or require this only while it does (DURING REPEAT OF …)";
  return renew + "; or, if the loop does not matter, end '" + verdict.requirement + "' with " + growth.phase +
         ", which leaves it out";
}

std::string hint_of(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  if (verdict.state == State::undecided) return hint_of_undecided(proof, index);
  if (verdict.loop_growth) return hint_of_growth(verdict);
  switch (verdict.measure) {
    case Measure::load:
    case Measure::busy:
      return "move modules to another processor, or shorten their activities";
    case Measure::response:
      if (verdict.witness && verdict.witness->failed)
        return "answer each event, on every way, before the next can come";
      return "shorten what the time is spent on, give it a processor of its own, or answer without waiting";
    case Measure::reaction:
      return "ask for the next value earlier, or shorten what lies between a value and its use";
    case Measure::interval:
      return verdict.at_least ? "wait for something that comes no sooner"
                              : "shorten what lies between two passes";
    case Measure::loss: {
      const analyzer::Device& device = proof.problem.devices[proof.problem.requirements[index].device];
      return std::holds_alternative<pan::EventDevice>(device.behaviour)
                 ? "take each event before the next can come, by a module with less to do for it, or let "
                   "them "
                   "come less often"
                 : "ask for the next one before working on the last";
    }
    case Measure::duration:
      return "shorten what lies between the start and the completion";
    case Measure::age:
      break;
  }
  if (!proof.problem.requirements[index].samples.empty())
    return "ask for the sample later, or more often, or shorten what lies between it and its use";
  if (const analyzer::Reason* wait = longest_wait_after_read(verdict))
    return "read the condition after " + wait->statement + ", not before it";
  if (const analyzer::Reason* wait = wait_between_set_and_read(verdict))
    return "set the condition after " + wait->statement + ", not before it";
  return "shorten what lies between the set and its use";
}

/// What is required says nothing about any run.
void report_never(const Proof& proof, std::size_t index, Diagnostics& diagnostics) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  Diagnostic& finding = diagnostics.report(
      either<Finding::load_says_nothing, Finding::says_nothing>(verdict.measure == Measure::load),
      verdict.where, verdict.requirement, verdict.explanation.text(), proof.problem.environment);
  finding.requirement = verdict.requirement;
}

/// Events that no thread takes are lost in PAL, and delay nobody. Elsewhere they may be kept.
void report_taken_as_lost(const Proof& proof, std::size_t index, Diagnostics& diagnostics) {
  const auto what = taken_as_lost(proof, index);
  if (!what) return;
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  diagnostics.report(*what, verdict.where).requirement = verdict.requirement;
}

// Lines of a story that fit on a screen with what else is said, and parts of one whole.
constexpr std::size_t most_lines = 14;
constexpr std::size_t most_parts = 4;

std::int64_t time_of(const analyzer::Reason& reason) {
  return reason.to - reason.from;
}

std::string indent(int depth) {
  return std::string(static_cast<std::size_t>(2 * depth), ' ');
}

Note note_of(const analyzer::Reason& reason, const analyzer::Problem& problem, int depth) {
  const std::string who = reason.actor.empty() ? "" : reason.actor + " ";
  return {place_of(problem, reason), Remark::part_of_run, indent(depth), to_text(Duration(time_of(reason))),
          who + reason.what};
}

/// All of them, in the order in which they happened, each with what is inside it.
void add_story(const std::vector<analyzer::Reason>& reasons, const analyzer::Problem& problem, int depth,
               Diagnostic& finding) {
  for (const analyzer::Reason& reason : analyzer::abridged(reasons)) {
    finding.notes.push_back(note_of(reason, problem, depth));
    add_story(reason.inside, problem, depth + 1, finding);
  }
}

/// The longest first, with what is inside it; of the rest how much it is. Whether there is more to tell.
bool add_longest(std::vector<analyzer::Reason> reasons, const analyzer::Problem& problem, int depth,
                 Diagnostic& finding) {
  std::stable_sort(reasons.begin(), reasons.end(), [](const analyzer::Reason& a, const analyzer::Reason& b) {
    return time_of(a) > time_of(b);
  });
  const std::size_t most = reasons.size() <= most_parts + 1 ? reasons.size() : most_parts;
  std::int64_t together = 0;
  bool more = false;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (i >= most) {
      together += time_of(reasons[i]);
      continue;
    }
    finding.notes.push_back(note_of(reasons[i], problem, depth));
    if (i > 0 || finding.notes.size() >= most_lines) {
      more = more || !reasons[i].inside.empty();
    } else {
      more = add_longest(reasons[i].inside, problem, depth + 1, finding);
    }
  }
  if (most == reasons.size()) return more;
  finding.note({}, Remark::shorter_parts, indent(depth), to_text(Duration(together)), reasons.size() - most);
  return true;
}

void report(const Proof& proof, std::size_t index, bool whole_story, Diagnostics& diagnostics) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  const bool fails = verdict.state == State::fails;
  Diagnostic& finding = diagnostics.report(
      either<Finding::requirement_fails, Finding::requirement_undecided>(fails), verdict.where,
      verdict.requirement, measure_text(proof.problem, index) + " " + known_figure(proof.problem, verdict),
      proof.problem.environment,
      std::string(verdict.allowed().text()) + " " + whole_text(verdict.allowed().figure),
      hint_of(proof, index));
  finding.requirement = verdict.requirement;
  if (verdict.loop_growth) {
    const analyzer::LoopId loop = verdict.loop_growth->loop;
    finding.note(loop.valid() ? proof.problem.loops[loop].where : verdict.where, Remark::explained,
                 verdict.explanation.text());
    if (!verdict.reasons.empty())
      finding.note(
          {}, Remark::in_first_turns,
          text(figure_of(verdict.measure, Duration(verdict.loop_growth->first_turns.measured.value))));
  }
  if (!fails || (verdict.reasons.empty() && !verdict.loop_growth))
    finding.note(verdict.where, Remark::explained, verdict.explanation.text());
  const auto shown = attained(verdict);
  if (!fails && shown && !verdict.reasons.empty())
    finding.note(verdict.where, Remark::worst_run_found, text(figure_of(verdict.measure, *shown)));
  if (verdict.reasons.empty()) return;
  if (whole_story) {
    add_story(verdict.reasons, proof.problem, 0, finding);
  } else if (add_longest(verdict.reasons, proof.problem, 0, finding)) {
    finding.note({}, Remark::explain_shows_all);
  }
}

}  // namespace

void report_zeno_run(const analyzer::Problem& problem, const analyzer::ZenoRun& zeno_run, Session& session) {
  const std::vector<analyzer::StatementId>& statements = zeno_run.statements;
  const auto where = [&problem](analyzer::StatementId statement) {
    return problem.statements[statement].where;
  };
  Diagnostic& finding = session.diagnostics.report(
      Finding::time_stands_still, statements.empty() ? SourceSpan{} : where(statements.front()),
      problem.environment);
  for (std::size_t i = 1; i < statements.size(); ++i)
    finding.note(where(statements[i]), Remark::also_in_loop);
}

std::optional<PartialDiagnostic> taken_as_lost(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  std::string lost;
  for (const analyzer::LostEvents& each : verdict.taken_as_lost) {
    const analyzer::Device& device = proof.problem.devices[each.device];
    lost += (lost.empty() ? "" : ", and ") + std::to_string(each.lost) + " of " + std::to_string(each.in) +
            " in a row of " + proof.problem.channels[device.event].message + " of " + device.name;
  }
  if (lost.empty()) return std::nullopt;
  return PartialDiagnostic(Finding::holds_with_lost_events, verdict.requirement, proof.problem.environment,
                           lost, proof.problem.devices[verdict.taken_as_lost.front().device].name);
}

bool look_for_zeno_run(const analyzer::Problem& problem, Session& session) {
  constexpr std::size_t classes = 5'000;
  if (!analyzer::fits_exploration(problem)) return false;
  const auto found = analyzer::find_zeno_run(problem, {classes, {}}).found;
  if (found) report_zeno_run(problem, *found, session);
  return found.has_value();
}

void report_unmet(const Proof& proof, std::size_t index, bool whole_story, Diagnostics& diagnostics) {
  const State state = proof.analysis.verdicts[index].state;
  if (state == State::never) report_never(proof, index, diagnostics);
  if (state == State::fails || state == State::undecided) report(proof, index, whole_story, diagnostics);
  report_taken_as_lost(proof, index, diagnostics);
}

void report_unmet(const std::vector<Proof>& proofs, bool whole_story, Session& session) {
  for (const Proof& proof : proofs) {
    if (proof.analysis.zeno_run) report_zeno_run(proof.problem, *proof.analysis.zeno_run, session);
    for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i)
      report_unmet(proof, i, whole_story, session.diagnostics);
  }
}

}  // namespace pal::program
