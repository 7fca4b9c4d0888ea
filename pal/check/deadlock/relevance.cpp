#include "pal/check/deadlock/relevance.hpp"

#include <optional>

namespace pal::check::deadlock {

namespace {

/// Steps that lead to each step.
std::vector<std::vector<std::size_t>> steps_before(const Automata& automata) {
  std::vector<std::vector<std::size_t>> result(automata.steps.size());
  for (std::size_t i = 0; i < automata.steps.size(); ++i) {
    for (const auto next : automata.steps[i].next) result[next].push_back(i);
  }
  return result;
}

/// Carries sets against the flow until nothing is new; a step keeps out what `stopped` has of it.
void spread(const Automata& automata, StepSets& sets, const StepSets* stopped) {
  const auto before = steps_before(automata);
  std::vector<std::size_t> open;
  std::vector<bool> is_open(automata.steps.size(), true);
  for (std::size_t i = 0; i < automata.steps.size(); ++i) open.push_back(i);
  while (!open.empty()) {
    const auto at = open.back();
    open.pop_back();
    is_open[at] = false;
    for (const auto from : before[at]) {
      if (!sets.join(from, at, stopped) || is_open[from]) continue;
      is_open[from] = true;
      open.push_back(from);
    }
  }
}

std::optional<std::size_t> bit_of(const Automata& automata, pan::ConditionId condition) {
  return automata.bit[condition.index()];
}

void add_guards(const Automata& automata, std::size_t step, StepSets& sets) {
  std::vector<pan::ConditionId> conditions;
  for (const auto& guard : automata.steps[step].guards) conditions::conditions_of(guard, conditions);
  for (const auto condition : conditions) {
    if (const auto bit = bit_of(automata, condition)) sets.add(step, *bit);
  }
}

}  // namespace

bool StepSets::join(std::size_t step, std::size_t from, const StepSets* without) {
  bool changed = false;
  for (std::size_t w = 0; w < words_; ++w) {
    auto added = static_cast<unsigned>(word(from, w));
    if (without != nullptr) added &= ~static_cast<unsigned>(without->word(step, w));
    auto& to = bits_[step * words_ + w];
    changed = changed || (added & ~static_cast<unsigned>(to)) != 0;
    to = static_cast<char16_t>(to | added);
  }
  return changed;
}

StepSets conditions_to_be_read(const Automata& automata) {
  StepSets read(automata.steps.size(), automata.bits);
  StepSets set(automata.steps.size(), automata.bits);
  for (std::size_t i = 0; i < automata.steps.size(); ++i) {
    const auto& step = automata.steps[i];
    add_guards(automata, i, read);
    if (step.kind != Step::Kind::set && step.kind != Step::Kind::latch) continue;
    if (const auto bit = bit_of(automata, step.condition))
      (step.kind == Step::Kind::set ? set : read).add(i, *bit);
  }
  spread(automata, read, &set);
  return read;
}

StepSets latches_to_be_read(const Automata& automata) {
  StepSets read(automata.steps.size(), automata.bits);
  StepSets stopped(automata.steps.size(), automata.bits);
  for (std::size_t i = 0; i < automata.steps.size(); ++i) {
    const auto& step = automata.steps[i];
    add_guards(automata, i, read);
    if (step.kind == Step::Kind::test) {
      for (std::size_t bit = 0; bit < automata.bits; ++bit) stopped.add(i, bit);
    } else if (step.kind == Step::Kind::latch) {
      if (const auto bit = bit_of(automata, step.condition)) stopped.add(i, *bit);
    }
  }
  spread(automata, read, &stopped);
  return read;
}

void close_over_future(const Automata& automata, StepSets& sets) {
  spread(automata, sets, nullptr);
}

}  // namespace pal::check::deadlock
