#include "pal/check/deadlock/simplify.hpp"

#include <algorithm>
#include <map>

namespace pal::check::deadlock {

namespace {

/// Some guard holds, whatever the conditions are.
bool exhaustive(const std::vector<pan::Guard>& guards) {
  std::vector<pan::ConditionId> conditions;
  for (const auto& guard : guards) conditions::conditions_of(guard, conditions);
  if (conditions.size() > conditions::most_read_at_once) return false;
  for (std::size_t bits = 0; bits < std::size_t{1} << conditions.size(); ++bits) {
    std::map<pan::ConditionId, bool> values;
    for (std::size_t i = 0; i < conditions.size(); ++i) values[conditions[i]] = (bits >> i & 1) != 0;
    const auto read = [&](pan::ConditionId condition) { return values.at(condition); };
    if (std::none_of(guards.begin(), guards.end(),
                     [&](const auto& guard) { return conditions::holds(guard, read); }))
      return false;
  }
  return true;
}

class Simplifier {
 public:
  explicit Simplifier(Automata& automata) : automata_(automata), passed_(automata.steps.size(), false) {}

  void simplify() {
    for (const auto& step : automata_.steps)
      never_faults_.push_back(step.otherwise || exhaustive(step.guards));
    find_pending_latches();
    bool changed = true;
    while (changed) {
      count_conditions();
      changed = false;
      for (std::size_t i = 0; i < automata_.steps.size(); ++i) {
        if (passed_[i] || !makes_no_difference(i)) continue;
        changed = true;
        if (delays_an_end(i)) {
          automata_.steps[i].kind = Step::Kind::work;
          automata_.steps[i].guards.clear();
          automata_.steps[i].next.resize(1);
        } else {
          passed_[i] = true;
        }
      }
      if (changed) bypass();
    }
    remove();
    number_conditions();
  }

 private:
  /// A latch waits for the next test, even for one that makes no other difference.
  void find_pending_latches() {
    pending_.assign(automata_.steps.size(), false);
    std::vector<std::size_t> open;
    const auto mark = [&](std::size_t step) {
      if (pending_[step]) return;
      pending_[step] = true;
      open.push_back(step);
    };
    for (const auto& step : automata_.steps) {
      if (step.kind == Step::Kind::latch) std::for_each(step.next.begin(), step.next.end(), mark);
    }
    while (!open.empty()) {
      const auto& step = automata_.steps[open.back()];
      open.pop_back();
      if (step.kind != Step::Kind::test) std::for_each(step.next.begin(), step.next.end(), mark);
    }
  }

  void count_conditions() {
    read_.assign(automata_.bit.size(), false);
    std::vector<pan::ConditionId> found;
    for (std::size_t i = 0; i < automata_.steps.size(); ++i) {
      if (passed_[i]) continue;
      for (const auto& guard : automata_.steps[i].guards) conditions::conditions_of(guard, found);
    }
    for (const auto condition : found) read_[condition.index()] = true;
  }

  bool makes_no_difference(std::size_t index) {
    const auto& step = automata_.steps[index];
    switch (step.kind) {
      case Step::Kind::set:
      case Step::Kind::latch:
        return !read_[step.condition.index()];
      case Step::Kind::test:
        return never_faults_[index] && !pending_[index] &&
               std::all_of(step.next.begin(), step.next.end(),
                           [&](auto next) { return next == step.next.front(); });
      case Step::Kind::work:
        return !delays_an_end(index);
      default:
        return false;
    }
  }

  /// After it a block may end at once, and cancel others.
  bool delays_an_end(std::size_t index) {
    const auto& step = automata_.steps[index];
    if (!end_may_cancel(automata_, step.thread)) return false;
    const auto kind = automata_.steps[target(step.next.front())].kind;
    return kind == Step::Kind::end || kind == Step::Kind::fork || kind == Step::Kind::enter;
  }

  /// The first step from here that is not passed over; going round for ever without one is a step of its own.
  std::size_t target(std::size_t from) {
    auto at = from;
    for (std::size_t passed = 0; passed_[at]; ++passed) {
      if (passed == automata_.steps.size()) {
        automata_.steps[at].kind = Step::Kind::spin;
        automata_.steps[at].guards.clear();
        passed_[at] = false;
        return at;
      }
      at = automata_.steps[at].next.front();
    }
    return at;
  }

  void bypass() {
    for (std::size_t i = 0; i < automata_.steps.size(); ++i) {
      for (auto& next : automata_.steps[i].next) {
        if (!passed_[i]) next = target(next);
      }
    }
    for (auto& thread : automata_.threads) thread.first = target(thread.first);
  }

  /// Steps keep their numbers. A step that no flow reaches sends and reads nothing.
  void remove() {
    for (std::size_t i = 0; i < automata_.steps.size(); ++i) {
      if (!passed_[i]) continue;
      auto& step = automata_.steps[i];
      step.kind = Step::Kind::end;
      step.next.clear();
      step.guards.clear();
    }
  }

  void number_conditions() {
    for (const auto& step : automata_.steps) {
      if (step.kind != Step::Kind::set) continue;
      auto& bit = automata_.bit[step.condition.index()];
      if (!bit) bit = automata_.bits++;
    }
  }

  Automata& automata_;
  std::vector<bool> passed_;
  std::vector<bool> never_faults_;
  std::vector<bool> pending_;
  std::vector<bool> read_;
};

}  // namespace

void simplify(Automata& automata) {
  Simplifier(automata).simplify();
}

}  // namespace pal::check::deadlock
