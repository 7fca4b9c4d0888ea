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

/// Whether a block somewhere uses what its module keeps of a message, and another thread of the module left
/// it there. A meter at run time sees messages and conditions, and not this.
class KeptMessages {
 public:
  explicit KeptMessages(const pan::Network& network) : network_(network) {
    for (std::size_t m = 0; m < network.modules.size(); ++m) {
      const pan::Module& module = network.modules[m];
      if (module.body.empty() || module.executed_by.valid()) continue;
      left_.clear();
      used_.clear();
      entered_.clear();
      follow(pan::ModuleId(m), 0, module.body.nodes.size(), begun_by(-1));
      for (const auto& [message, users] : used_) {
        for (const int leaver : left_[message]) {
          for (const int user : users) crosses_ = crosses_ || !is_within(user, leaver);
        }
      }
    }
  }

  bool crosses() const { return crosses_; }

 private:
  /// A new thread.
  int begun_by(int parent) {
    parents_.push_back(parent);
    return static_cast<int>(parents_.size()) - 1;
  }

  /// What a thread knows as it begins blocks they know, too.
  bool is_within(int thread, int outer) const {
    for (; thread >= 0; thread = parents_[static_cast<std::size_t>(thread)]) {
      if (thread == outer) return true;
    }
    return false;
  }

  void follow(pan::ModuleId id, std::size_t begin, std::size_t end, int thread) {
    const std::vector<pan::Node>& nodes = network_.modules[id.index()].body.nodes;
    for (std::size_t n = begin; n < end; ++n) {
      const pan::Node& node = nodes[n];
      if (const auto* fork = std::get_if<pan::Fork>(&node.content)) {
        for (std::size_t i = 0; i < fork->threads.size(); ++i) {
          const std::size_t last = i + 1 < node.out.size() ? node.out[i + 1].index() : node.mate.index();
          follow(id, node.out[i].index(), last, begun_by(thread));
        }
        n = node.mate.index();
      } else if (const auto* execute = std::get_if<pan::Execute>(&node.content)) {
        if (!entered_.insert({execute->module.value, thread}).second) continue;
        follow(execute->module, 0, network_.modules[execute->module.index()].body.nodes.size(), thread);
      } else {
        note(node.content, thread);
      }
    }
  }

  void note(const pan::Content& content, int thread) {
    const auto add = [&](const std::vector<pan::MessageId>& messages,
                         std::map<std::int32_t, std::set<int>>& to) {
      for (const pan::MessageId message : messages) to[message.value].insert(thread);
    };
    if (const auto* wait = std::get_if<pan::Wait>(&content)) {
      for (const pan::ChannelId channel : wait->channels)
        add({network_.channels[channel.index()].message}, left_);
    } else if (const auto* send = std::get_if<pan::Send>(&content)) {
      add({network_.channels[send->channel.index()].message}, used_);
    } else if (const auto* perform = std::get_if<pan::Perform>(&content)) {
      add(network_.activities[perform->activity.index()].reads, used_);
      add(network_.activities[perform->activity.index()].writes, left_);
    } else if (const auto* set = std::get_if<pan::Set>(&content); set != nullptr && !set->value) {
      add(network_.conditions[set->condition.index()].from, used_);
    }
  }

  const pan::Network& network_;
  std::map<std::int32_t, std::set<int>> left_;  // threads, by message
  std::map<std::int32_t, std::set<int>> used_;
  std::set<std::pair<std::int32_t, int>> entered_;
  std::vector<int> parents_;
  bool crosses_ = false;
};

class RequirementPlanner {
 public:
  RequirementPlanner(const pan::Network& network, Plan& plan)
      : crosses_blocks_(KeptMessages(network).crosses()),
        network_(network),
        plan_(plan),
        reliance_(network, plan) {}

  void plan() {
    for (const pan::Requirement& requirement : network_.requirements) {
      PlannedRequirement made;
      made.name = requirement.name;
      made.most = requirement.limit;
      std::vector<std::size_t> about;
      std::visit([&](const auto& measure) { fill(measure, made, about); }, requirement.measure);
      if (made.measure == Measure::sample && crosses_blocks_) made.measure = Measure::other;
      if (requirement.phase) made.measure = PlannedRequirement().measure;  // is not followed at run time
      add(std::move(made), about);
    }
    for (const pan::DeviceTiming& timing : plan_.environment.devices) demanded_answer(timing);
  }

 private:
  void add(PlannedRequirement made, const std::vector<std::size_t>& about) {
    reliance_.of(about, made);
    plan_.requirements.push_back(std::move(made));
  }

  void at(const std::vector<pan::StatementRef>& statements, PlannedRequirement& made,
          std::vector<std::size_t>& about) {
    for (std::size_t s = 0; s < plan_.statements.size(); ++s) {
      const PlannedRow& row = plan_.statements[s];
      const bool meant =
          std::any_of(statements.begin(), statements.end(), [&row](const pan::StatementRef& ref) {
            return ref.module == row.pan_module && ref.node == row.pan_node;
          });
      if (meant) made.at.push_back(s);
    }
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

  void about_processors(const std::string& name, std::vector<std::size_t>& about) {
    for (std::size_t p = 0; p < plan_.environment.processors.size(); ++p) {
      if (!name.empty() && plan_.environment.processors[p].name != name) continue;
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
    at(reaction.at, made, about);
  }
  void fill(const pan::Passes& passes, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::interval;
    made.least = passes.least.value_or(Duration{});
    made.most = passes.most;
    at(passes.at, made, about);
  }
  void fill(const pan::Loss& loss, PlannedRequirement&, std::vector<std::size_t>& about) {
    const auto* module = std::get_if<pan::ModuleId>(&loss.of);
    about.push_back(reliance_.party(module != nullptr
                                        ? network_.modules[module->index()].name
                                        : network_.devices[std::get<pan::DeviceId>(loss.of).index()].name));
  }
  void fill(const pan::Completing& completing, PlannedRequirement& made, std::vector<std::size_t>& about) {
    made.measure = Measure::duration;
    made.code = completing.code;
    about.push_back(reliance_.party(network_.modules[network_.main.index()].name));
  }
  void fill(const pan::Load& load, PlannedRequirement&, std::vector<std::size_t>& about) {
    about_processors(load.processor, about);
  }
  void fill(const pan::BusyPeriod& busy, PlannedRequirement&, std::vector<std::size_t>& about) {
    about_processors(busy.processor, about);
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

  bool crosses_blocks_ = false;
  const pan::Network& network_;
  Plan& plan_;
  Reliance reliance_;
};

}  // namespace

void plan_requirements(const pan::Network& network, Plan& plan) {
  RequirementPlanner(network, plan).plan();
}

}  // namespace pal::codegen
