#include "codegen/promises.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace pal::codegen {
namespace {

using Measure = PlannedRequirement::Measure;

/// Which parties can delay which: modules with all that they execute, named by the outermost of them, and
/// devices. A party relies on those with whom it exchanges messages, and on those that set the conditions
/// that it reads. It also relies on those that its processors serve before it. That is more than an analysis
/// that looks closer would say, never less.
class Reliance {
 public:
  Reliance(const pan::Network& network, const Plan& plan) : plan_(plan) {
    for (std::size_t m = 0; m < plan.modules.size(); ++m) {
      const PlannedModule& module = plan.modules[m];
      const std::size_t root = module.keeper.value_or(m);
      parties_[module.pal_name] = root;
      conditions_of(module.body, read_[root]);
    }
    for (std::size_t d = 0; d < plan.devices.size(); ++d)
      parties_.emplace(plan.devices[d], plan.modules.size() + d);
    size_ = plan.modules.size() + plan.devices.size();
    talks_.resize(size_);
    for (const PlannedChannel& channel : plan.channels) {
      talks_[party(channel.sender)].push_back(party(channel.receiver));
      talks_[party(channel.receiver)].push_back(party(channel.sender));
    }
    for (const pan::Condition& condition : network.conditions) {
      const bool set = condition.writer.valid();
      writers_.push_back(set ? parties_.at(network.modules[condition.writer.index()].name) : size_);
    }
    by_processor_.resize(plan.environment.processors.size());
    for (std::size_t t = 0; t < plan.threads.size(); ++t)
      by_processor_[plan.threads[t].processor].push_back(t);
    for (auto& threads : by_processor_) {
      std::stable_sort(threads.begin(), threads.end(), [&plan](std::size_t a, std::size_t b) {
        return plan.threads[a].priority > plan.threads[b].priority;
      });
    }
  }

  std::size_t party(const std::string& name) const { return parties_.at(name); }
  std::size_t writer(std::size_t condition) const { return writers_[condition]; }
  std::size_t party_of_thread(std::size_t thread) const {
    const std::size_t module = plan_.threads[thread].module;
    return plan_.modules[module].keeper.value_or(module);
  }
  std::vector<std::size_t> on_processor(std::size_t processor) const {
    std::vector<std::size_t> result;
    for (const std::size_t thread : by_processor_[processor]) result.push_back(party_of_thread(thread));
    return result;
  }

  /// Fills threads and devices of `requirement`, which is about `parties`.
  void of(const std::vector<std::size_t>& parties, PlannedRequirement& requirement) const {
    std::vector<bool> reached(size_);
    std::vector<std::size_t> served(by_processor_.size());  // how many threads of a processor are reached
    std::vector<std::size_t> open;
    const auto reach = [&](std::size_t party) {
      if (party >= size_ || reached[party]) return;
      reached[party] = true;
      open.push_back(party);
    };
    for (const std::size_t party : parties) reach(party);
    while (!open.empty()) {
      const std::size_t party = open.back();
      open.pop_back();
      for (const std::size_t other : talks_[party]) reach(other);
      if (party >= plan_.modules.size()) continue;
      if (const auto read = read_.find(party); read != read_.end()) {
        for (const std::size_t condition : read->second) reach(writers_[condition]);
      }
      for (std::size_t p = 0; p < by_processor_.size(); ++p) serve(p, party, served[p], reach);
    }
    for (std::size_t t = 0; t < plan_.threads.size(); ++t) {
      if (!plan_.threads[t].parent && reached[party_of_thread(t)]) requirement.threads.push_back(t);
    }
    for (std::size_t d = 0; d < plan_.devices.size(); ++d) {
      if (reached[plan_.modules.size() + d]) requirement.devices.push_back(d);
    }
  }

 private:
  static void conditions_of(const pan::Guard& guard, std::set<std::size_t>& found) {
    if (guard.kind == pan::Guard::Kind::equals) found.insert(guard.condition.index());
    for (const pan::Guard& term : guard.terms) conditions_of(term, found);
  }
  static void conditions_of(const PlannedBody& body, std::set<std::size_t>& found) {
    for (const PlannedStatement& statement : body) {
      if (statement.kind == PlannedStatement::Kind::read) found.insert(*statement.condition);
      for (const pan::Guard& guard : statement.guards) conditions_of(guard, found);
      for (const PlannedBody& branch : statement.branches) conditions_of(branch, found);
    }
  }

  /// Those whom the processor serves before the last thread of `party`, or while it cannot be interrupted.
  template <class Reach>
  void serve(std::size_t processor, std::size_t party, std::size_t& served, Reach reach) const {
    const std::vector<std::size_t>& threads = by_processor_[processor];
    std::size_t last = threads.size();
    while (last > served && party_of_thread(threads[last - 1]) != party) --last;
    if (last <= served) return;
    const int priority = plan_.threads[threads[last - 1]].priority;
    const bool preemptive = plan_.environment.processors[processor].preemptive;
    while (served < threads.size() && (!preemptive || plan_.threads[threads[served]].priority >= priority))
      reach(party_of_thread(threads[served++]));
  }

  const Plan& plan_;
  std::size_t size_ = 0;
  std::map<std::string, std::size_t> parties_;  // a module by its root, then devices
  std::vector<std::vector<std::size_t>> talks_;
  std::map<std::size_t, std::set<std::size_t>> read_;   // conditions, by party
  std::vector<std::size_t> writers_;                    // by condition
  std::vector<std::vector<std::size_t>> by_processor_;  // threads, the greatest priority first
};

class RequirementPlanner {
 public:
  RequirementPlanner(const pan::Network& network, Plan& plan)
      : network_(network), plan_(plan), reliance_(network, plan) {}

  void plan() {
    for (const pan::Requirement& requirement : network_.requirements) {
      PlannedRequirement made;
      made.name = requirement.name;
      made.most = requirement.limit;
      std::vector<std::size_t> about;
      std::visit([&](const auto& measure) { fill(measure, made, about); }, requirement.measure);
      if (requirement.phase) phase(*requirement.phase, made);
      add(std::move(made), about);
    }
    for (const pan::DeviceTiming& timing : plan_.environment.devices) demanded_answer(timing);
    keep();
  }

 private:
  /// One with two limits is two, as in the proof.
  void add(PlannedRequirement made, const std::vector<std::size_t>& about) {
    if (made.measure == Measure::loss && !made.device) return;
    reliance_.of(about, made);
    if (made.least > Duration{} && made.most) {
      PlannedRequirement least = made;
      least.name += ".least";
      least.most.reset();
      plan_.requirements.push_back(std::move(least));
      made.name += ".most";
      made.least = {};
    }
    plan_.requirements.push_back(std::move(made));
  }

  std::vector<std::size_t> rows(const std::vector<pan::StatementRef>& statements) const {
    std::vector<std::size_t> found;
    for (std::size_t s = 0; s < plan_.statements.size(); ++s) {
      const PlannedRow& row = plan_.statements[s];
      const bool meant =
          std::any_of(statements.begin(), statements.end(), [&row](const pan::StatementRef& ref) {
            return ref.module == row.pan_module && ref.node == row.pan_node;
          });
      if (meant) found.push_back(s);
    }
    return found;
  }

  void phase(const pan::Phase& phase, PlannedRequirement& made) {
    made.after = rows(phase.after);
    for (const pan::StatementRef& ref : phase.during) {
      for (PlannedModule& module : plan_.modules) {
        if (module.pal_name != network_.modules[ref.module.index()].name) continue;
        if (const auto number = number_of_loop(module.body, ref.node)) made.during.push_back(*number);
      }
    }
  }

  /// The loop gets a number if it has none.
  std::optional<std::size_t> number_of_loop(PlannedBody& body, pan::NodeId node) {
    for (PlannedStatement& statement : body) {
      if (statement.kind == PlannedStatement::Kind::loop && statement.pan_node == node) {
        if (!statement.loop) statement.loop = loops_++;
        return statement.loop;
      }
      for (PlannedBody& branch : statement.branches) {
        if (const auto number = number_of_loop(branch, node)) return number;
      }
    }
    return std::nullopt;
  }

  // What modules keep of messages. One that executes others keeps it for them.

  std::size_t root(std::size_t module) const { return plan_.modules[module].keeper.value_or(module); }

  std::size_t module_named(const std::string& name) const {
    std::size_t m = 0;
    while (m < plan_.modules.size() && plan_.modules[m].pal_name != name) ++m;
    return m;
  }

  void keep() {
    const bool samples =
        std::any_of(plan_.requirements.begin(), plan_.requirements.end(), [](const PlannedRequirement& each) {
          return each.measure == Measure::sample || each.measure == Measure::sample_reaction;
        });
    if (!samples) return;
    std::map<std::pair<std::size_t, std::int32_t>, std::size_t> kept;  // by module and message
    using How = PlannedKept::How;
    for (std::size_t s = 0; s < plan_.statements.size(); ++s) {
      const PlannedRow& row = plan_.statements[s];
      const std::size_t module = root(module_named(row.module));
      const auto add = [&](How how, const std::vector<pan::MessageId>& messages) {
        for (const pan::MessageId message : messages) {
          if (network_.messages[message.index()].fields.empty()) continue;
          const auto found = kept.try_emplace({module, message.value}, kept.size()).first;
          plan_.kept.push_back({how, s, found->second});
        }
      };
      const pan::Content& content = network_.modules[row.pan_module.index()].body[row.pan_node].content;
      if (const auto* send = std::get_if<pan::Send>(&content)) {
        add(How::used, {network_.channels[send->channel.index()].message});
      } else if (const auto* perform = std::get_if<pan::Perform>(&content)) {
        add(How::used, network_.activities[perform->activity.index()].reads);
        add(How::written, network_.activities[perform->activity.index()].writes);
      } else if (const auto* set = std::get_if<pan::Set>(&content); set != nullptr && !set->value) {
        add(How::used, network_.conditions[set->condition.index()].from);
      }
    }
    for (std::size_t c = 0; c < plan_.channels.size(); ++c) {
      const std::size_t module = module_named(plan_.channels[c].receiver);
      if (module == plan_.modules.size()) continue;
      const auto found = kept.find({root(module), network_.channels[c].message.value});
      if (found != kept.end()) plan_.kept.push_back({How::taken, c, found->second});
    }
  }

  void at(const std::vector<pan::StatementRef>& statements, PlannedRequirement& made,
          std::vector<std::size_t>& about) {
    made.at = rows(statements);
    for (const pan::StatementRef& ref : statements)
      about.push_back(reliance_.party(network_.modules[ref.module.index()].name));
  }

  void from(const std::vector<pan::ChannelId>& channels, PlannedRequirement& made,
            std::vector<std::size_t>& about) {
    for (const pan::ChannelId channel : channels) {
      made.channels.push_back(channel.index());
      about.push_back(reliance_.party(plan_.channels[channel.index()].sender));
      about.push_back(reliance_.party(plan_.channels[channel.index()].receiver));
    }
  }

  void about_known(const pan::Known& known, PlannedRequirement& made, std::vector<std::size_t>& about) {
    if (const auto* condition = std::get_if<pan::ConditionId>(&known)) {
      made.condition = condition->index();
      about.push_back(reliance_.writer(condition->index()));
    } else {
      from(std::get<std::vector<pan::ChannelId>>(known), made, about);
    }
  }

  void about_processors(const std::string& name, PlannedRequirement& made, std::vector<std::size_t>& about) {
    for (std::size_t p = 0; p < plan_.environment.processors.size(); ++p) {
      if (!name.empty() && plan_.environment.processors[p].name != name) continue;
      made.processors.push_back(p);
      for (const std::size_t party : reliance_.on_processor(p)) about.push_back(party);
    }
  }

  void fill(const pan::Response& response, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::response;
    from(response.of, made, about);
    at(response.at, made, about);
  }
  void fill(const pan::Age& age, PlannedRequirement& made, std::vector<std::size_t>& about) {
    about_known(age.of, made, about);
    made.measure = made.condition ? Measure::age : Measure::sample;
    at(age.at, made, about);
  }
  void fill(const pan::Reaction& reaction, PlannedRequirement& made, std::vector<std::size_t>& about) {
    about_known(reaction.of, made, about);
    made.measure = made.condition ? Measure::reaction : Measure::sample_reaction;
    at(reaction.at, made, about);
  }
  void fill(const pan::Passes& passes, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::interval;
    made.least = passes.least.value_or(Duration{});
    made.most = passes.most;
    at(passes.at, made, about);
  }
  void fill(const pan::Loss& loss, PlannedRequirement& made, std::vector<std::size_t>& about) {
    const auto* module = std::get_if<pan::ModuleId>(&loss.of);
    const std::string& name = module != nullptr
                                  ? network_.modules[module->index()].name
                                  : network_.devices[std::get<pan::DeviceId>(loss.of).index()].name;
    made.measure = Measure::loss;
    made.most = Duration(loss.most);
    made.in = loss.in;
    const auto device = std::find(plan_.devices.begin(), plan_.devices.end(), name);
    if (device == plan_.devices.end()) return;  // it has no part in the skill
    made.device = static_cast<std::size_t>(device - plan_.devices.begin());
    about.push_back(reliance_.party(name));
  }
  void fill(const pan::Completing& completing, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::duration;
    made.code = completing.code;
    about.push_back(reliance_.party(network_.modules[network_.main.index()].name));
  }
  void fill(const pan::Load& load, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::load;
    about_processors(load.processor, made, about);
  }
  void fill(const pan::BusyPeriod& busy, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::busy;
    about_processors(busy.processor, made, about);
  }

  /// What an event device demands of the module that takes its events.
  void demanded_answer(const pan::DeviceTiming& timing) {
    const auto* event = std::get_if<pan::EventDevice>(&timing.behaviour);
    if (event == nullptr || !event->answer_within) return;
    PlannedRequirement made;
    made.name = timing.device + ".answer";
    made.measure = Measure::response;
    made.most = *event->answer_within;
    std::vector<std::size_t> about;
    std::vector<pan::ChannelId> events;
    for (std::size_t c = 0; c < plan_.channels.size(); ++c) {
      const PlannedChannel& channel = plan_.channels[c];
      if (channel.sender == timing.device && channel.message == event->message) events.emplace_back(c);
    }
    if (events.empty()) return;
    from(events, made, about);
    std::vector<pan::StatementRef> answers;
    for (const PlannedRow& row : plan_.statements) {
      const auto& content = network_.modules[row.pan_module.index()].body[row.pan_node].content;
      const auto* send = std::get_if<pan::Send>(&content);
      if (send == nullptr) continue;
      const PlannedChannel& channel = plan_.channels[send->channel.index()];
      if (channel.receiver == timing.device && channel.message == event->answer)
        answers.push_back({row.pan_module, row.pan_node});
    }
    at(answers, made, about);
    add(std::move(made), about);
  }

  const pan::Network& network_;
  Plan& plan_;
  Reliance reliance_;
  std::size_t loops_ = 0;
};

}  // namespace

void plan_requirements(const pan::Network& network, Plan& plan) {
  RequirementPlanner(network, plan).plan();
}

}  // namespace pal::codegen
