#include "pal/check/deadlock/story.hpp"

#include "pal/pan/dump.hpp"

namespace pal::check::deadlock {

namespace {

class Teller {
 public:
  Teller(const pan::Network& network, const Automata& automata) : network_(network), automata_(automata) {}

  const std::string& message(pan::ChannelId channel) const {
    return network_.messages[network_.channels[channel.index()].message.index()].name;
  }
  const std::string& sender(pan::ChannelId channel) const {
    return party_name(network_, network_.channels[channel.index()].sender);
  }
  const std::string& receiver(pan::ChannelId channel) const {
    return party_name(network_, network_.channels[channel.index()].receiver);
  }
  SourceSpan where(const Step& step) const {
    return network_.modules[step.module.index()].body[step.node].where;
  }
  const std::string& condition(const Step& step) const {
    return network_.conditions[step.condition.index()].name;
  }

  std::string found(const Step& step, std::size_t branch) const {
    if (branch < step.guards.size()) return "finds " + guard_text(network_, step.guards[branch]);
    if (step.otherwise) return "finds that " + guard_text(network_, step.guards.front()) + " does not hold";
    return "finds that no arm holds";
  }

  std::string text(const Action& action) const {
    const auto& step = automata_.steps[action.step];
    const auto truth = [&] { return std::string(action.value ? "TRUE" : "FALSE"); };
    switch (action.kind) {
      case Action::Kind::takes:
        return "takes '" + message(action.channel) + "' from " + sender(action.channel);
      case Action::Kind::sends:
        return "sends '" + message(action.channel) + "' to " + receiver(action.channel);
      case Action::Kind::discards:
        return "sends '" + message(action.channel) + "', which " + receiver(action.channel) + " has given up";
      case Action::Kind::gives_up:
        return "gives up waiting for '" + message(action.channel) + "'";
      case Action::Kind::loses:
        return "loses an answer: the one before it is still in its slot";
      case Action::Kind::sets:
        return "sets " + condition(step) + " to " + truth();
      case Action::Kind::latches:
        return "reads " + condition(step) + " as " + truth();
      case Action::Kind::finds:
        return found(step, action.branch);
      case Action::Kind::faults:
        return "finds that no arm holds";
      case Action::Kind::completes:
        return "completes the skill";
      case Action::Kind::stops:
        return "stops: it is cancelled";
      case Action::Kind::works:
        return "goes on";
      case Action::Kind::spins:
        return "goes round";
    }
    return {};
  }

  std::string stuck(const Stuck& at) const {
    const auto& step = automata_.steps[at.step];
    if (step.kind == Step::Kind::send) {
      return "cannot send '" + message(step.channels.front()) + "': " + receiver(step.channels.front()) +
             " has not taken the last one";
    }
    std::string result = "waits for ";
    for (std::size_t i = 0; i < step.channels.size(); ++i) {
      result += (i == 0 ? "'" : " or '") + message(step.channels[i]) + "' from " + sender(step.channels[i]);
    }
    if (at.never_asked) result += ", without an open request for it";
    return result;
  }

  std::string hint(const DeadEnd& end) const {
    if (end.stuck.empty()) return {};
    const auto& culprit = end.stuck[end.culprit];
    const auto& step = automata_.steps[culprit.step];
    const auto channel = step.channels.front();
    if (step.kind == Step::Kind::send)
      return "let " + receiver(channel) + " take every '" + message(channel) +
             "' before it waits for anything else";
    if (culprit.never_asked)
      return "send TXM( request " + message(channel) + " from " + sender(channel) + " ) before this wait";
    return "let " + sender(channel) + " send '" + message(channel) +
           "' on every way through it, or wait WITHIN a time";
  }

 private:
  const pan::Network& network_;
  const Automata& automata_;
};

bool has_channel(Action::Kind kind) {
  return kind == Action::Kind::takes || kind == Action::Kind::sends || kind == Action::Kind::discards;
}

Story story_of(const std::vector<Action>& run, const Teller& teller, const Automata& automata) {
  Story story;
  for (const auto& thread : automata.threads) {
    story.lanes.push_back(thread.name);
    story.modules.push_back(thread.module);
  }
  for (const auto& action : run) {
    if (action.kind == Action::Kind::spins || action.kind == Action::Kind::works) continue;
    Line line{automata.threads[action.thread].name,
              teller.text(action),
              teller.where(automata.steps[action.step]),
              action.kind,
              action.thread,
              std::nullopt};
    if (has_channel(action.kind)) line.channel = action.channel;
    story.run.push_back(std::move(line));
  }
  return story;
}

}  // namespace

Story tell(const pan::Network& network, const Automata& automata, const DeadEnd& end) {
  const Teller teller(network, automata);
  Story story = story_of(end.run, teller, automata);
  story.total = end.total;
  story.timely = end.timely;
  for (std::size_t i = 0; i < end.stuck.size(); ++i) {
    const auto& one = end.stuck[i];
    story.stuck.push_back({automata.threads[one.thread].name, teller.stuck(one),
                           teller.where(automata.steps[one.step]), one.thread, i == end.culprit});
  }
  story.hint = teller.hint(end);
  return story;
}

Story tell(const pan::Network& network, const Automata& automata, const Undelivered& undelivered) {
  Story story = story_of(undelivered.run, Teller(network, automata), automata);
  story.timely = undelivered.timely;
  story.undelivered = undelivered.channel;
  return story;
}

}  // namespace pal::check::deadlock
