#include "pal/check/conditions/condition_runs.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "pal/check/conditions/condition_blocks.hpp"
#include "pal/check/conditions/condition_concern.hpp"
#include "pal/check/conditions/condition_state.hpp"
#include "pal/check/conditions/guards.hpp"
#include "pal/pan/threads.hpp"

namespace pal::check::conditions {

namespace {

using namespace conditions;

constexpr std::size_t most_states = 50'000;
constexpr std::size_t most_parts = 2'000'000;  // threads, calls and values of all states: some 200 MB

struct Origin {
  const State* from = nullptr;
  std::optional<RunStep> step;
};

bool holds_for(const pan::Guard& guard, const Values& reading) {
  return holds(guard, [&](pan::ConditionId condition) { return reading.at(condition); });
}

std::string truth(bool value) {
  return value ? "TRUE" : "FALSE";
}

class ConditionExplorer {
 public:
  ConditionExplorer(const pan::Network& network, const pan::Flow& flow, pan::ModuleId root)
      : network_(network), flow_(flow), concern_(network, root) {
    State first;
    Thread main;
    main.module = root;
    main.at = {root, pan::NodeId(0)};
    first.threads.push_back(main);
    for (const auto c : concern_.own()) first.values[c] = false;
    reach(std::move(first), nullptr, std::nullopt);
  }

  ConditionRuns run() {
    while (!open_.empty()) {
      if (seen_.size() > most_states || parts_ > most_parts) {
        give_up();
        break;
      }
      const State& state = *open_.front();
      open_.pop_front();
      for (const auto& thread : state.threads) {
        if (parts_ > most_parts) break;
        if (!thread.ended && !thread.waits_for_blocks) step(state, thread);
      }
    }
    return std::move(result_);
  }

 private:
  const pan::Node& node(const Place& place) const {
    return network_.modules[place.module.index()].body[place.node];
  }

  void reach(State state, const State* from, std::optional<RunStep> step) {
    const auto [entry, fresh] = seen_.emplace(std::move(state), Origin{from, std::move(step)});
    if (!fresh) return;
    open_.push_back(&entry->first);
    parts_ += entry->first.threads.size() + entry->first.values.size();
    for (const auto& thread : entry->first.threads) parts_ += thread.calls.size() + thread.latched.size();
  }

  /// `thread` of a copy of the state.
  static Thread& at(State& state, const Thread& thread) {
    return state.threads[static_cast<std::size_t>(thread.number)];
  }

  void go(const State& from, State state, const Thread& thread, pan::NodeId to, std::optional<RunStep> step) {
    if (!to.valid()) return;
    auto& place = at(state, thread).at;
    place.node = to;
    place = concern_.settled(place);
    reach(std::move(state), &from, std::move(step));
  }

  void step(const State& state, const Thread& thread) {
    const auto& content = node(thread.at).content;
    if (std::holds_alternative<pan::Complete>(content)) return;
    if (std::holds_alternative<pan::End>(content)) return end(state, thread);
    if (const auto* fork = std::get_if<pan::Fork>(&content)) return begin_blocks(state, thread, *fork);
    if (const auto* set = std::get_if<pan::Set>(&content)) return this->set(state, thread, *set);
    if (const auto* read = std::get_if<pan::Read>(&content)) return this->read(state, thread, *read);
    if (const auto* choose = std::get_if<pan::Choose>(&content)) return this->choose(state, thread, *choose);
    if (const auto* until = std::get_if<pan::Until>(&content)) return this->until(state, thread, *until);
    if (const auto* execute = std::get_if<pan::Execute>(&content)) {
      if (!network_.modules[execute->module.index()].body.empty()) {
        State next = state;
        auto& caller = at(next, thread);
        caller.calls.push_back(thread.at);
        caller.at = concern_.settled({execute->module, pan::NodeId(0)});
        return reach(std::move(next), &state, std::nullopt);
      }
    }
    for (const auto to : node(thread.at).out) go(state, state, thread, to, std::nullopt);
  }

  std::string name_of(const State& state, const Thread& thread) const {
    const auto& text = network_.modules[thread.module.index()].threads[thread.name];
    if (thread.parent < 0) return text;
    // Its parent runs the body of its module, or is a block of that module itself.
    const auto above = [&state](const Thread& of) {
      return &state.threads[static_cast<std::size_t>(of.parent)];
    };
    const Thread* runner = above(thread);
    while (runner->calls.empty() && runner->parent >= 0) runner = above(*runner);
    return pan::block_name(name_of(state, *runner), runner->parent >= 0, text);
  }

  RunStep told(const State& state, const Thread& thread, std::string what) const {
    return {name_of(state, thread), thread.at.module, thread.at.node, std::move(what)};
  }

  void set(const State& state, const Thread& thread, const pan::Set& set) {
    const auto to = node(thread.at).out.front();
    if (!concern_.sets(set.condition)) return go(state, state, thread, to, std::nullopt);
    for (const bool value : {true, false}) {
      if (set.value && *set.value != value) continue;
      State next = state;
      next.values[set.condition] = value;
      go(state, std::move(next), thread, to, told(state, thread, set_text(set, value)));
    }
  }

  std::string set_text(const pan::Set& set, bool value) const {
    return "sets " + network_.conditions[set.condition.index()].name + " to " + truth(value);
  }

  /// The values that a condition can have when it is read now.
  std::vector<bool> values_of(const State& state, pan::ConditionId condition) const {
    if (const auto own = state.values.find(condition); own != state.values.end()) return {own->second};
    if (!network_.conditions[condition.index()].writer.valid()) return {false};
    return {false, true};  // another thread sets it
  }

  void read(const State& state, const Thread& thread, const pan::Read& read) {
    const auto to = node(thread.at).out.front();
    if (!concern_.is_tested(read.condition)) return go(state, state, thread, to, std::nullopt);
    for (const bool value : values_of(state, read.condition)) {
      State next = state;
      at(next, thread).latched[read.condition] = value;
      const auto& name = network_.conditions[read.condition.index()].name;
      go(state, std::move(next), thread, to, told(state, thread, "reads " + name + " as " + truth(value)));
    }
  }

  /// Every way in which the conditions of a test can be read at one instant.
  std::vector<Values> readings(const State& state, const Thread& thread,
                               const std::vector<pan::ConditionId>& conditions) const {
    std::vector<Values> result{{}};
    for (const auto condition : conditions) {
      const auto latched = thread.latched.find(condition);
      const auto values =
          latched != thread.latched.end() ? std::vector<bool>{latched->second} : values_of(state, condition);
      std::vector<Values> more;
      for (const auto& reading : result) {
        for (const bool value : values) {
          more.push_back(reading);
          more.back()[condition] = value;
        }
      }
      result = std::move(more);
    }
    return result;
  }

  std::string reading_text(const Values& reading) const {
    std::string result;
    for (const auto& [condition, value] : reading) {
      result +=
          (result.empty() ? "" : ", ") + network_.conditions[condition.index()].name + " = " + truth(value);
    }
    return result;
  }

  void choose(const State& state, const Thread& thread, const pan::Choose& choose) {
    auto& outcome = result_.cases[std::pair(thread.at.module, thread.at.node)];
    outcome.taken.resize(choose.guards.size());
    std::vector<pan::ConditionId> conditions;
    for (const auto& guard : choose.guards) conditions_of(guard, conditions);
    if (conditions.size() > most_read_at_once) return give_up();
    for (const auto& reading : readings(state, thread, conditions)) {
      const auto arm = std::find_if(choose.guards.begin(), choose.guards.end(),
                                    [&](const pan::Guard& guard) { return holds_for(guard, reading); });
      if (arm == choose.guards.end()) {
        // The search goes breadth first, so the first run found is a shortest one.
        if (outcome.no_arm_holds) continue;
        outcome.no_arm_holds = run_to(state);
        outcome.no_arm_holds->push_back(told(state, thread, "finds " + reading_text(reading)));
        continue;
      }
      const auto index = static_cast<std::size_t>(arm - choose.guards.begin());
      outcome.taken[index] = true;
      State next = state;
      at(next, thread).latched.clear();
      go(state, std::move(next), thread, node(thread.at).out[index],
         told(state, thread, "finds " + reading_text(reading)));
    }
  }

  /// Ends the search: what was found stands, what was not proves nothing.
  void give_up() {
    result_.complete = false;
    open_.clear();
  }

  void until(const State& state, const Thread& thread, const pan::Until& until) {
    const auto& here = node(thread.at);
    if (!until.guard) return go(state, state, thread, here.mate, std::nullopt);
    std::vector<pan::ConditionId> conditions;
    conditions_of(*until.guard, conditions);
    if (conditions.size() > most_read_at_once) return give_up();
    auto& ends = result_.loops[std::pair(thread.at.module, thread.at.node)];
    for (const auto& reading : readings(state, thread, conditions)) {
      ends = ends || holds_for(*until.guard, reading);
      const auto to = holds_for(*until.guard, reading) ? here.out.front() : here.mate;
      State next = state;
      at(next, thread).latched.clear();
      go(state, std::move(next), thread, to, told(state, thread, "finds " + reading_text(reading)));
    }
  }

  void begin_blocks(const State& state, const Thread& thread, const pan::Fork& fork) {
    State next = state;
    const auto& here = node(thread.at);
    at(next, thread).waits_for_blocks = true;
    for (std::size_t i = 0; i < fork.threads.size(); ++i) {
      Thread block;
      block.number = static_cast<std::int32_t>(next.threads.size());
      block.parent = thread.number;
      block.module = thread.at.module;
      block.name = fork.threads[i];
      block.can_end = flow_.block_can_end(thread.at.module, here.out[i]);
      block.at = concern_.settled({thread.at.module, here.out[i]});
      block.latched = thread.latched;
      next.threads.push_back(std::move(block));
    }
    reach(std::move(next), &state, std::nullopt);
  }

  void end(const State& state, const Thread& thread) {
    if (!thread.calls.empty()) {
      State next = state;
      auto& caller = at(next, thread);
      caller.at = caller.calls.back();
      caller.calls.pop_back();
      return go(state, next, caller, node(caller.at).out.front(), std::nullopt);
    }
    if (thread.parent < 0) return;
    State next = state;
    at(next, thread).ended = true;
    const auto open = [&](const Thread& t) { return t.parent == thread.parent && t.can_end && !t.ended; };
    if (std::any_of(next.threads.begin(), next.threads.end(), open)) {
      return reach(std::move(next), &state, std::nullopt);
    }
    for (auto& ending : endings(network_, concern_, next, thread.parent)) {
      std::optional<RunStep> step;
      if (const auto& last = ending.last)
        step = told(state, last->block, set_text(last->set, last->value) + " before it is cancelled");
      reach(std::move(ending.state), &state, std::move(step));
    }
  }

  std::vector<RunStep> run_to(const State& state) const {
    std::vector<RunStep> steps;
    for (const State* at = &state; at != nullptr;) {
      const auto& origin = seen_.at(*at);
      if (origin.step) steps.push_back(*origin.step);
      at = origin.from;
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  const pan::Network& network_;
  const pan::Flow& flow_;
  Concern concern_;
  std::map<State, Origin> seen_;
  std::size_t parts_ = 0;
  std::deque<const State*> open_;
  ConditionRuns result_;
};

}  // namespace

ConditionRuns explore_conditions(const pan::Network& network, const pan::Flow& flow, pan::ModuleId root) {
  return ConditionExplorer(network, flow, root).run();
}

}  // namespace pal::check::conditions
