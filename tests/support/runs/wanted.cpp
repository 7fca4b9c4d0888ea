#include "tests/support/runs/wanted.hpp"

namespace pal::test {

using namespace pan;

namespace {

std::set<std::pair<int, int>> places(const std::vector<StatementRef>& refs) {
  std::set<std::pair<int, int>> set;
  for (const StatementRef& ref : refs) set.insert({ref.module.value, ref.node.value});
  return set;
}

std::vector<int> processors(const Environment& environment, const std::string& name) {
  std::vector<int> found;
  for (std::size_t p = 0; p < environment.processors.size(); ++p) {
    if (name.empty() || environment.processors[p].name == name) found.push_back(static_cast<int>(p));
  }
  return found;
}

void take_known(const Known& known, Wanted::Kind condition, Wanted::Kind sample, Wanted& made) {
  if (const auto* of = std::get_if<ConditionId>(&known)) {
    made.kind = condition;
    made.condition = of->value;
    return;
  }
  made.kind = sample;
  for (const ChannelId channel : std::get<std::vector<ChannelId>>(known)) made.samples.insert(channel.value);
}

class Wishes {
 public:
  Wishes(const Network& network, const Environment& environment, std::vector<Wanted>& all)
      : network_(network), environment_(environment), all_(all) {}

  void add(const Requirement& requirement) {
    made_ = {};
    made_.name = requirement.name;
    if (requirement.phase) {
      made_.after = places(requirement.phase->after);
      for (const StatementRef& loop : requirement.phase->during) {
        const NodeId until = network_.modules[loop.module.index()].body[loop.node].mate;
        made_.loops.insert({loop.module.value, {loop.node.value, until.value}});
      }
    }
    std::visit(*this, requirement.measure);
  }

  void operator()(const Response& response) {
    made_.kind = Wanted::Kind::response;
    for (const ChannelId channel : response.of) made_.events.insert(channel.value);
    made_.at = places(response.at);
    all_.push_back(made_);
  }
  void operator()(const Age& age) {
    take_known(age.of, Wanted::Kind::age, Wanted::Kind::sample_age, made_);
    made_.at = places(age.at);
    all_.push_back(made_);
  }
  void operator()(const Reaction& reaction) {
    take_known(reaction.of, Wanted::Kind::reaction, Wanted::Kind::sample_reaction, made_);
    made_.at = places(reaction.at);
    all_.push_back(made_);
  }
  void operator()(const Passes& passes) {
    made_.at = places(passes.at);
    const std::string name = made_.name;
    const bool both = passes.least && passes.most;
    if (passes.least) {
      made_.kind = Wanted::Kind::least;
      made_.name = both ? name + ".least" : name;
      all_.push_back(made_);
    }
    if (!passes.most) return;
    made_.kind = Wanted::Kind::greatest;
    made_.name = both ? name + ".most" : name;
    all_.push_back(made_);
  }
  void operator()(const Loss& loss) {
    made_.kind = Wanted::Kind::loss;
    made_.in = loss.in;
    made_.device =
        std::visit([&](const auto& of) -> std::string { return party_name(network_, Party(of)); }, loss.of);
    all_.push_back(made_);
  }
  void operator()(const Completing& completing) {
    made_.kind = Wanted::Kind::duration;
    made_.code = completing.code;
    all_.push_back(made_);
  }
  void operator()(const Load& load) {
    made_.kind = Wanted::Kind::load;
    made_.processors = processors(environment_, load.processor);
    all_.push_back(made_);
  }
  void operator()(const BusyPeriod& busy) {
    made_.kind = Wanted::Kind::busy;
    made_.processors = processors(environment_, busy.processor);
    all_.push_back(made_);
  }

  /// ANSWER x WITHIN D is a response to TXM( x ).
  void add(const DeviceTiming& timing) {
    const auto* event = std::get_if<EventDevice>(&timing.behaviour);
    if (event == nullptr || event->answer.empty() || !event->answer_within) return;
    Wanted answer;
    answer.name = timing.device + ".answer";
    answer.kind = Wanted::Kind::response;
    for (std::size_t c = 0; c < network_.channels.size(); ++c) {
      if (party_name(network_, network_.channels[c].sender) == timing.device &&
          network_.messages[network_.channels[c].message.index()].name == event->message)
        answer.events.insert(static_cast<int>(c));
    }
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const Graph& body = network_.modules[m].body;
      for (std::size_t n = 0; n < body.nodes.size(); ++n) {
        const auto* send = std::get_if<Send>(&body.nodes[n].content);
        if (send == nullptr) continue;
        const Channel& channel = network_.channels[send->channel.index()];
        if (party_name(network_, channel.receiver) == timing.device &&
            network_.messages[channel.message.index()].name == event->answer)
          answer.at.insert({static_cast<int>(m), static_cast<int>(n)});
      }
    }
    all_.push_back(answer);
  }

 private:
  const Network& network_;
  const Environment& environment_;
  std::vector<Wanted>& all_;
  Wanted made_;
};

}  // namespace

std::string party_name(const Network& network, const Party& party) {
  if (const auto* device = std::get_if<DeviceId>(&party)) return network.devices[device->index()].name;
  return network.modules[std::get<ModuleId>(party).index()].name;
}

std::vector<Wanted> wanted(const Network& network, const Environment& environment) {
  std::vector<Wanted> all;
  Wishes wishes(network, environment, all);
  for (const Requirement& requirement : network.requirements) wishes.add(requirement);
  for (const DeviceTiming& timing : environment.devices) wishes.add(timing);
  return all;
}

}  // namespace pal::test
