// Deadlocks and lost messages, as findings.
#include <string>

#include "pal/check/deadlock/explore.hpp"
#include "pal/check/deadlock/story.hpp"
#include "pal/check/report.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::check {

namespace {

constexpr std::size_t most_notes = 40;
// Of a warning: the end of the run says how it comes about, and pal sequence draws all of it.
constexpr std::size_t most_notes_of_a_warning = 8;

void add_run(const deadlock::Story& story, std::size_t most, Diagnostic& finding) {
  const auto first = story.run.size() > most ? story.run.size() - most : 0;
  for (auto i = first; i < story.run.size(); ++i) {
    const auto& line = story.run[i];
    const char* lead = i == first ? (first == 0 ? "first, " : "in the end, ") : "then ";
    finding.notes.push_back({line.where, lead + line.thread + " " + line.text});
  }
}

void report_dead_end(const deadlock::Story& story, const pan::Network& network, Diagnostics& diagnostics) {
  const deadlock::StuckLine* culprit = nullptr;
  for (const auto& line : story.stuck) {
    if (line.culprit) culprit = &line;
  }
  if (culprit == nullptr) return;
  auto code = story.total ? Code::PAL0521 : Code::PAL0522;
  auto message = story.total ? "skill " + quoted(network.skill.name) + " can deadlock: "
                             : "skill " + quoted(network.skill.name) + " can come to wait for ever: ";
  if (story.timely) {
    code = Code::PAL0523;
    message = "at unlucky times, " + message;
  }
  auto& finding =
      diagnostics.report(code, culprit->where, message + culprit->thread + " " + culprit->text, story.hint);
  add_run(story, most_notes, finding);
  for (const auto& line : story.stuck) {
    if (!line.culprit) finding.notes.push_back({line.where, "and for ever " + line.thread + " " + line.text});
  }
}

void report_undelivered(const deadlock::Undelivered& undelivered, const deadlock::Story& story,
                        const pan::Network& network, Diagnostics& diagnostics) {
  const auto& channel = network.channels[undelivered.channel.index()];
  const auto& message = network.messages[channel.message.index()].name;
  const auto& receiver = party_name(network, channel.receiver);
  auto& finding = diagnostics.report(
      Code::PAL0527, story.run.back().where,
      "the skill can complete before " + receiver + " has taken " + quoted(message) + ", which is then lost",
      "before the completion wait for what " + receiver + " sends when it has taken it, as its next request");
  add_run(story, most_notes_of_a_warning, finding);
}

void report_untaken(const pan::Channel& channel, const pan::Network& network, Diagnostics& diagnostics) {
  const auto& message = network.messages[channel.message.index()].name;
  diagnostics.report(Code::PAL0524, channel.where,
                     "no run of the skill takes " + quoted(message) + " from " +
                         party_name(network, channel.sender) + ": " + party_name(network, channel.receiver) +
                         " never reaches a wait for it in time",
                     "let " + party_name(network, channel.receiver) + " take it, or do not send it");
}

}  // namespace

void check_deadlocks(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics,
                     const std::function<bool()>& stop) {
  if (!network.main.valid()) return;
  const auto automata = deadlock::automata(network, flow);
  deadlock::Limits limits;
  limits.stop = stop;
  const auto findings = deadlock::explore(automata, limits);
  for (const auto& end : {findings.total, findings.partial}) {
    if (end) report_dead_end(deadlock::tell(network, automata, *end), network, diagnostics);
  }
  for (const auto channel : findings.untaken) {
    report_untaken(network.channels[channel.index()], network, diagnostics);
  }
  for (const auto& undelivered : findings.undelivered) {
    report_undelivered(undelivered, deadlock::tell(network, automata, undelivered), network, diagnostics);
  }
  if (findings.complete) return;
  const auto begin = "skill " + quoted(network.skill.name);
  if (findings.stopped) {
    diagnostics.report(Code::PAL0525, network.skill.where,
                       begin + " was not searched for deadlocks to the end: the time ran out",
                       "give a longer --timeout; the search takes half of it at most");
  } else if (findings.overflowed) {
    diagnostics.report(Code::PAL0525, network.skill.where,
                       begin +
                           " can have more than 12 requests for one message open at once, or withdrawn and "
                           "yet to be answered: a "
                           "deadlock could not be excluded",
                       "let every request be answered, or taken back, before the next one");
  } else {
    diagnostics.report(Code::PAL0525, network.skill.where,
                       begin + " has too many states to exclude a deadlock: " +
                           std::to_string(findings.states) + " were looked at",
                       "check parts of it as skills of their own");
  }
}

}  // namespace pal::check
