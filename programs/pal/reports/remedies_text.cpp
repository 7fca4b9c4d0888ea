// What mends a requirement, as text.
#include <fmt/format.h>

#include <sstream>

#include "pal/support/duration_text.hpp"
#include "programs/pal/reports/whatif_answer.hpp"
#include "programs/pal/session/measure_text.hpp"

namespace pal::program {
namespace {

using State = analyzer::VerdictState;

std::string plural(std::size_t number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

/// The lines that go, come and stand around them, without the names of the files.
std::string edit_lines(const ProgramChange& change) {
  std::string out;
  std::istringstream lines(change.difference);
  for (std::string line; std::getline(lines, line);) {
    const bool head = line.starts_with("---") || line.starts_with("+++") || line.starts_with("@@");
    if (!head) out += "         " + line + "\n";
  }
  return out;
}

std::string change_lines(const WhatIfAnswer& answer, const analyzer::whatif::Candidate& candidate,
                         bool first) {
  std::string out = first ? "" : "       and ";
  if (candidate.program.valid()) {
    const ProgramChange& change = answer.program_changes[candidate.program.index()];
    const std::string where = change.module.empty() ? "" : "in " + change.module + ", ";
    return out + fmt::format("{}{}:{}: {}\n", where, change.file, change.line, change.title) +
           edit_lines(change);
  }
  std::string options;
  for (const analyzer::whatif::Change& each : candidate.changes) {
    out += (&each == &candidate.changes.front() ? "" : " and ") + words(each);
    options += " --set '" + text(each) + "'";
  }
  return out + ":" + options + "\n";
}

std::string state_text(const analyzer::Verdict& verdict) {
  if (verdict.state == State::never) return "it says nothing";
  return std::string(analyzer::name(verdict.state)) + " " + bound_text(verdict);
}

/// What did not hold before, or does not now; of the rest how many.
std::string verdict_lines(const analyzer::whatif::Remedies& remedies,
                          const analyzer::whatif::Remedy& remedy) {
  std::string out;
  std::size_t others = 0;
  for (std::size_t r = 0; r < remedy.after.size(); ++r) {
    const analyzer::Verdict& before = remedies.before[r];
    const analyzer::Verdict& after = remedy.after[r];
    if (before.state == State::holds && after.state == State::holds) {
      ++others;
      continue;
    }
    out += fmt::format("       '{}', {} {}: before {}, after {}\n", after.requirement,
                       whole_text(after.allowed().figure), after.at_least ? "required" : "allowed",
                       state_text(before), state_text(after));
  }
  if (others > 0)
    out +=
        "       " + plural(others, "other requirement") + (others == 1 ? " holds" : " hold") + " as before\n";
  return out;
}

std::string remedy_lines(const WhatIfAnswer& answer, const analyzer::whatif::Remedy& remedy,
                         const std::string& mark) {
  std::string out = "  " + mark;
  for (const analyzer::whatif::CandidateId id : remedy.made)
    out += change_lines(answer, answer.remedies->candidates[id.index()], id == remedy.made.front());
  return out + verdict_lines(*answer.remedies, remedy);
}

std::string short_enough_lines(const WhatIfAnswer& answer) {
  std::string out;
  analyzer::RequirementId of;
  for (const analyzer::whatif::ShortEnough& each : answer.remedies->short_enough) {
    if (each.requirement != of) {
      out += fmt::format("  '{}' holds with one time shorter; each of these suffices:\n",
                         answer.requirements[each.requirement.index()]);
      of = each.requirement;
    }
    const std::string enough = to_text(each.enough);
    out += fmt::format("       {}: {} instead of {}: --set '{} = {}'\n", each.figure, enough,
                       to_text(each.time), each.figure, enough);
  }
  return out;
}

std::string tried_lines(const WhatIfAnswer& answer) {
  const analyzer::whatif::Remedies& remedies = *answer.remedies;
  if (remedies.tried == 0 && remedies.found.empty()) return "";
  const std::string ended = remedies.complete ? "" : "; the time ended before all were";
  if (remedies.found.empty()) {
    std::string out = "  No change was found that makes all requirements hold (" +
                      plural(remedies.tried, "attempt") + ended + ").\n";
    if (remedies.nearest) {
      out += "  The nearest single change:\n";
      out += remedy_lines(answer, *remedies.nearest, "     ");
    }
    return out;
  }
  const std::size_t size = remedies.found.front().made.size();
  std::string out = "  With " + std::string(size == 1 ? "one change" : plural(size, "change") + " together") +
                    " all requirements hold (" + plural(remedies.tried, "attempt") + ended + "):\n";
  std::size_t number = 0;
  for (const analyzer::whatif::Remedy& remedy : remedies.found)
    out += remedy_lines(answer, remedy, fmt::format("{:>3}. ", ++number));
  return out;
}

}  // namespace

std::string remedies_text(const WhatIfAnswer& answer) {
  return answer.remedies ? tried_lines(answer) + short_enough_lines(answer) : "";
}

}  // namespace pal::program
