// The answer as tables.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "pal/support/duration_text.hpp"
#include "programs/pal/reports/whatif_answer.hpp"

namespace pal::program {
namespace {

using analyzer::whatif::Slack;
using State = analyzer::VerdictState;

std::string named(const WhatIfAnswer& answer, analyzer::RequirementId requirement) {
  return requirement.valid() ? answer.requirements[requirement.index()] : "";
}

std::string slack_text(const Slack& slack) {
  if (slack.unlimited) return "unlimited";
  if (!slack.holds) return slack.fails ? "none" : "not known";
  return (slack.exact() ? "" : ">= ") + to_text(*slack.holds);
}

std::string reason_text(const WhatIfAnswer& answer, const Slack& slack) {
  if (slack.unlimited) return "";
  if (!slack.requirement.valid()) {
    const bool some = slack.holds && slack.holds->count() > 0;
    return std::string(some ? "further " : "") + "not looked for: the search was ended before";
  }
  const std::string name = named(answer, slack.requirement);
  if (!slack.holds)
    return "'" + name + (slack.fails ? "' does not hold" : "' is undecided") + " as things are";
  if (slack.exact()) return "then '" + name + "' fails";
  const std::string open = slack.ended ? "not decided in the time given" : "undecided";
  if (slack.fails) return "'" + name + "' fails at " + to_text(*slack.fails) + " more; between is " + open;
  return "beyond that '" + name + "' is " + open;
}

std::string now_text(const Slack& slack) {
  return slack.figure.empty() ? to_text(slack.time.worst) : to_text(slack.time);
}

std::string percent(const Slack& slack) {
  if (!slack.holds || slack.time.worst.count() == 0 || slack.unlimited) return "";
  __extension__ using Wide = __int128;
  const auto tenths =
      static_cast<std::int64_t>(static_cast<Wide>(slack.holds->count()) * 1000 / slack.time.worst.count());
  return fmt::format("{}.{} %", tenths / 10, tenths % 10);
}

std::vector<std::string> names_of(const std::vector<Slack>& slacks) {
  std::vector<std::string> names;
  for (const Slack& slack : slacks) names.push_back(slack.figure);
  return names;
}

/// Whether one requirement that does not hold as things are leaves no figure any slack.
bool is_hopeless(const WhatIfAnswer& answer) {
  const Slack& first = answer.slacks.front();
  return std::all_of(answer.slacks.begin(), answer.slacks.end(), [&](const Slack& slack) {
    return !slack.holds && slack.fails && slack.requirement.valid() && slack.requirement == first.requirement;
  });
}

std::string slack_table(const WhatIfAnswer& answer) {
  if (answer.slacks.empty()) return "";
  if (is_hopeless(answer))
    return "  '" + named(answer, answer.slacks.front().requirement) +
           "' does not hold as things are, so no worst time may grow.\n";
  const SlackTable table(names_of(answer.slacks));
  std::string out = table.heading();
  for (const Slack& slack : answer.slacks) out += table.row(answer, slack);
  return out;
}

std::string change_table(const WhatIfAnswer& answer) {
  if (answer.before_and_after.size() != 2) return "";
  std::size_t width = 11;
  for (const std::string& name : answer.requirements) width = std::max(width, name.size());
  std::string out = fmt::format("  {:{}}  {:>9}  {:9}  {:>12}    {:9}  {:>12}\n", "requirement", width,
                                "limit", "before", "", "after", "");
  const auto& before = answer.before_and_after[0].analysis.verdicts;
  const auto& after = answer.before_and_after[1].analysis.verdicts;
  for (std::size_t r = 0; r < after.size(); ++r) {
    out += fmt::format("  {:{}}  {:>9}  {:9}  {:>12}  {} {:9}  {:>12}\n", after[r].requirement, width,
                       whole_text(after[r].allowed().figure), analyzer::name(before[r].state),
                       bound_text(before[r]), before[r].state == after[r].state ? " " : "*",
                       analyzer::name(after[r].state), bound_text(after[r]));
  }
  return out;
}

std::string seats_text(const analyzer::whatif::Placements& on, const analyzer::whatif::Placed& placed) {
  std::map<analyzer::ProcessorId, std::string> by;
  for (const analyzer::whatif::ThreadPlacement& each : placed.threads)
    by[each.processor] += " " + each.thread + "(" + std::to_string(each.priority) + ")";
  std::string out;
  for (const auto& [processor, threads] : by) {
    out += (out.empty() ? "" : "; ") + on.names[processor.index()] + ":" + threads;
  }
  return out;
}

std::string placement_lines(const WhatIfAnswer& answer, const analyzer::whatif::Placements& on) {
  if (on.tried == 0 && on.complete)
    return fmt::format("  {} processors: more than there are threads to place\n", on.processors);
  std::string out = fmt::format(
      "  {} processor{}: {} placement{} tried, {} meet{} every requirement, {} refuted, {} undecided{}\n",
      on.processors, on.processors == 1 ? "" : "s", on.tried, on.tried == 1 ? "" : "s", on.meet.size(),
      on.meet.size() == 1 ? "s" : "", on.refuted.size(), on.undecided.size(),
      on.complete ? "" : "; not all were tried");
  for (std::size_t r = 0; r < on.broken.size(); ++r) {
    if (on.broken[r] > 0)
      out += fmt::format("    a run breaks '{}' in {}\n", answer.requirements[r], on.broken[r]);
  }
  for (const auto& placed : on.meet) out += "    meets      " + seats_text(on, placed) + "\n";
  for (const auto& placed : on.undecided) {
    out += "    undecided  " + seats_text(on, placed) + "\n";
  }
  return out;
}

std::string conclusion(const WhatIfAnswer& answer) {
  if (!answer.fewest || answer.placements.empty()) return "";
  const analyzer::whatif::Placements& last = answer.placements.back();
  if (last.meet.empty()) return "  No placement was found that meets every requirement.\n";
  const bool proved = std::all_of(answer.placements.begin(), answer.placements.end() - 1,
                                  [](const auto& on) { return on.complete && on.undecided.empty(); });
  if (last.processors == 1) return "  One processor does.\n";
  // Without --priorities nothing is said of other ones.
  const std::string kept = answer.priorities ? "" : "with the priorities as they are ";
  return fmt::format("  {} processors do; {}.\n", last.processors,
                     proved
                         ? kept + "fewer do not: each placement on fewer has a run that breaks a requirement"
                         : "that fewer do not is not proved");
}

}  // namespace

SlackTable::SlackTable(const std::vector<std::string>& figures) {
  for (const std::string& figure : figures) width_ = std::max(width_, figure.size());
}

std::string SlackTable::heading() const {
  return fmt::format("  {:{}}  {:>17}  {:>15}  {:>10}\n", "worst time of", width_, "now", "may grow by", "");
}

std::string SlackTable::row(const WhatIfAnswer& answer, const Slack& slack) const {
  const std::string name = slack.figure.empty() ? "all together" : slack.figure;
  return fmt::format("  {:{}}  {:>17}  {:>15}  {:>10}  {}\n", name, width_, now_text(slack),
                     slack_text(slack), slack.figure.empty() ? percent(slack) : "",
                     reason_text(answer, slack));
}

std::string text(const WhatIfAnswer& answer) {
  std::string out;
  if (!answer.slacks_shown) out = answer.skill + " in " + answer.environment + "\n" + slack_table(answer);
  out += remedies_text(answer) + change_table(answer);
  for (const analyzer::whatif::Placements& on : answer.placements) out += placement_lines(answer, on);
  return out + conclusion(answer);
}

}  // namespace pal::program
