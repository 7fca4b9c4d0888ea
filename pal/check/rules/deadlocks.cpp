// Deadlocks and lost messages, as findings.

#include "pal/check/deadlock/explore.hpp"
#include "pal/check/deadlock/story.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

constexpr std::size_t most_notes = 40;
// Of a warning: the end of the run says how it comes about, and pal sequence draws all of it.
constexpr std::size_t most_notes_of_a_warning = 8;

void add_run(const deadlock::Story& story, std::size_t most, Diagnostic& finding) {
  const auto first = story.run.size() > most ? story.run.size() - most : 0;
  for (auto i = first; i < story.run.size(); ++i) {
    const auto& line = story.run[i];
    finding.note(line.where, i == first ? beginning_of_run(first == 0) : RemarkWith<2>(Remark::next_of_run),
                 line.thread, line.text);
  }
}

void report_dead_end(const deadlock::Story& story, const pan::Network& network, Diagnostics& diagnostics) {
  const deadlock::StuckLine* culprit = nullptr;
  for (const auto& line : story.stuck) {
    if (line.culprit) culprit = &line;
  }
  if (culprit == nullptr) return;
  const auto what =
      story.timely
          ? either<Finding::deadlock_at_unlucky_times, Finding::waits_for_ever_at_unlucky_times>(story.total)
          : either<Finding::deadlock, Finding::waits_for_ever>(story.total);
  auto& finding = diagnostics.report(what, culprit->where, network.skill.name, culprit->thread, culprit->text,
                                     story.hint);
  add_run(story, most_notes, finding);
  for (const auto& line : story.stuck) {
    if (!line.culprit) finding.note(line.where, Remark::and_for_ever, line.thread, line.text);
  }
}

void report_undelivered(const deadlock::Undelivered& undelivered, const deadlock::Story& story,
                        const pan::Network& network, Diagnostics& diagnostics) {
  const auto& channel = network.channels[undelivered.channel.index()];
  const auto& message = network.messages[channel.message.index()].name;
  const auto& receiver = party_name(network, channel.receiver);
  auto& finding = diagnostics.report(Finding::undelivered_at_end, story.run.back().where, receiver, message);
  add_run(story, most_notes_of_a_warning, finding);
}

void report_untaken(const pan::Channel& channel, const pan::Network& network, Diagnostics& diagnostics) {
  const auto& message = network.messages[channel.message.index()].name;
  diagnostics.report(Finding::message_never_taken, channel.where, message,
                     party_name(network, channel.sender), party_name(network, channel.receiver));
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
  if (findings.stopped) {
    diagnostics.report(Finding::search_ran_out_of_time, network.skill.where, network.skill.name);
  } else if (findings.overflowed) {
    diagnostics.report(Finding::too_many_requests_open, network.skill.where, network.skill.name);
  } else {
    diagnostics.report(Finding::too_many_states, network.skill.where, network.skill.name, findings.states);
  }
}

}  // namespace pal::check
