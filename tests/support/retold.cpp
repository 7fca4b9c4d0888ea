#include "tests/support/retold.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

using namespace pal::analyzer;

namespace pal::test {
namespace {

using Order = std::vector<int>;  // by old number: the new one

class Retelling {
 public:
  Retelling(Problem& problem, std::mt19937_64& engine) : problem_(problem), engine_(engine) {}

  std::string one() {
    switch (chance(8)) {
      case 0:
        return processors(), "other numbers of processors";
      case 1:
        return threads(), "other numbers of threads";
      case 2:
        return channels(), "other numbers of channels";
      case 3:
        return devices(), "other numbers of devices";
      case 4:
        return preemption(), "other kinds of processors with one thread";
      case 5:
        return company(), "company";
      case 6:
        return twins(), "twins";
      default:
        return parts(), "parts";
    }
  }

 private:
  std::size_t chance(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  Order order(std::size_t n) {
    Order made(n);
    std::iota(made.begin(), made.end(), 0);
    std::shuffle(made.begin(), made.end(), engine_);
    return made;
  }

  static void renumber(int& number, const Order& order) {
    if (number >= 0) number = order[static_cast<std::size_t>(number)];
  }

  template <class Tag>
  static void renumber(Id<Tag>& id, const Order& order) {
    if (id.valid()) id = Id<Tag>(static_cast<std::size_t>(order[id.index()]));
  }

  template <class Number>
  static void renumber(std::vector<Number>& numbers, const Order& order) {
    for (Number& number : numbers) renumber(number, order);
  }

  template <class Thing>
  static void rearrange(std::vector<Thing>& things, const Order& order) {
    std::vector<Thing> made(things.size());
    for (std::size_t i = 0; i < things.size(); ++i)
      made[static_cast<std::size_t>(order[i])] = std::move(things[i]);
    things = std::move(made);
  }

  template <class I, class Thing>
  static void rearrange(Table<I, Thing>& things, const Order& order) {
    Table<I, Thing> made(things.size());
    for (const I id : things.ids())
      made[I(static_cast<std::size_t>(order[id.index()]))] = std::move(things[id]);
    things = std::move(made);
  }

  void processors() {
    const Order to = order(problem_.processors.size());
    rearrange(problem_.processors, to);
    for (Thread& thread : problem_.threads) renumber(thread.processor, to);
    for (Channel& channel : problem_.channels) renumber(channel.receiver_processors, to);
    for (Requirement& requirement : problem_.requirements) renumber(requirement.processors, to);
    renumber(problem_.overloaded, to);
  }

  /// A block stands behind its parent.
  void threads() {
    const std::size_t n = problem_.threads.size();
    Order to(n, -1);
    for (int placed = 0; placed < static_cast<int>(n);) {
      const ThreadId thread(chance(n));
      const ThreadId parent = problem_.threads[thread].parent;
      if (to[thread.index()] < 0 && (!parent.valid() || to[parent.index()] >= 0))
        to[thread.index()] = placed++;
    }
    rearrange(problem_.threads, to);
    for (Thread& thread : problem_.threads) renumber(thread.parent, to);
    for (Step& step : problem_.steps) renumber(step.threads, to);
  }

  void channels() {
    const Order to = order(problem_.channels.size());
    rearrange(problem_.channels, to);
    for (Channel& channel : problem_.channels) {
      renumber(channel.answer, to);
      renumber(channel.answers, to);
    }
    for (Step& step : problem_.steps) renumber(step.channels, to);
    for (Device& device : problem_.devices) {
      renumber(device.event, to);
      renumber(device.requests, to);
      std::shuffle(device.requests.begin(), device.requests.end(), engine_);
    }
    for (Requirement& requirement : problem_.requirements) {
      renumber(requirement.samples, to);
      renumber(requirement.events, to);
    }
  }

  void devices() {
    const Order to = order(problem_.devices.size());
    rearrange(problem_.devices, to);
    for (Channel& channel : problem_.channels) {
      renumber(channel.sender_device, to);
      renumber(channel.receiver_device, to);
    }
    for (Requirement& requirement : problem_.requirements) renumber(requirement.device, to);
  }

  void preemption() {
    for (const ProcessorId p : problem_.processors.ids()) {
      const auto on = std::count_if(problem_.threads.begin(), problem_.threads.end(),
                                    [p](const Thread& each) { return each.processor == p; });
      if (on <= 1) problem_.processors[p].preemptive = !problem_.processors[p].preemptive;
    }
  }

  /// A thread on its own processor that computes for ever.
  void company() {
    const StepId step = add({});
    Step& made = problem_.steps[step];
    made.kind = Step::Kind::activity;
    made.statement = StatementId{0};
    made.cost = {1'000'000, 1'000'000 * static_cast<Nanoseconds>(1 + chance(2))};
    made.next = {step};
    Thread thread;
    thread.name = "Stranger";
    thread.module = pan::ModuleId(problem_.module_names.size());
    thread.processor = ProcessorId(problem_.processors.size());
    thread.can_end = false;
    thread.entry = step;
    problem_.module_names.push_back(thread.name);
    problem_.threads.push_back(thread);
    pan::Processor elsewhere;
    elsewhere.name = "Elsewhere";
    problem_.processors.push_back(elsewhere);
    problem_.conditions.push_back("unused");
  }

  StepId add(const Step& step) {
    const StepId made = problem_.steps.push_back(step);
    for (Requirement& requirement : problem_.requirements) {
      if (!requirement.at.empty()) requirement.at.push_back(false);
    }
    return made;
  }

  /// The step once more, with what is measured at it.
  StepId copy(StepId step) {
    const StepId made = add(Step(problem_.steps[step]));
    for (Requirement& requirement : problem_.requirements) {
      if (!requirement.at.empty()) requirement.at.back() = requirement.at[step];
    }
    return made;
  }

  void twins() {
    for (std::size_t times = 1 + chance(3); times > 0; --times) {
      const StepId step(chance(problem_.steps.size()));
      const StepId twin = copy(step);
      const auto either = [&](StepId& to) {
        if (to == step && chance(2) == 0) to = twin;
      };
      for (Step& each : problem_.steps) {
        for (StepId& next : each.next) either(next);
      }
      for (Thread& each : problem_.threads) either(each.entry);
    }
  }

  /// The statements of threads that may be cancelled: one that has begun is finished, a second part is not.
  Table<StepId, bool> cancellable() const {
    Table<StepId, bool> found(problem_.steps.size());
    for (const Thread& thread : problem_.threads) {
      bool may = false;
      for (const Thread* at = &thread; at->parent.valid(); at = &problem_.threads[at->parent])
        may = may || !at->can_end;
      if (!may) continue;
      std::vector<StepId> todo{thread.entry};
      while (!todo.empty()) {
        const StepId step = todo.back();
        todo.pop_back();
        if (found[step]) continue;
        found[step] = true;
        todo.insert(todo.end(), problem_.steps[step].next.begin(), problem_.steps[step].next.end());
      }
    }
    return found;
  }

  void parts() {
    const Table<StepId, bool> whole = cancellable();
    for (std::size_t times = 1 + chance(3); times > 0; --times) {
      const StepId step(chance(whole.size()));
      const Step::Kind kind = problem_.steps[step].kind;
      if (whole[step] || kind == Step::Kind::wait || kind == Step::Kind::fork || kind == Step::Kind::end)
        continue;
      const StepId second = copy(step);
      Step& first = problem_.steps[step];
      Step& rest = problem_.steps.back();
      for (Requirement& requirement : problem_.requirements) {
        if (!requirement.at.empty()) requirement.at[step] = false;
      }
      first = {};
      first.kind = Step::Kind::activity;
      first.statement = rest.statement;
      first.cost = {rest.cost.best / 1'000'000 / 2 * 1'000'000, 0};
      first.cost.worst = first.cost.best + (rest.cost.worst - rest.cost.best) / 1'000'000 / 2 * 1'000'000;
      if (chance(3) == 0) first.cost = {0, 0};
      rest.cost.best -= first.cost.best;
      rest.cost.worst -= first.cost.worst;
      first.next = {second};
      return;
    }
  }

  Problem& problem_;
  std::mt19937_64& engine_;
};

}  // namespace

std::string retell(Problem& problem, std::mt19937_64& engine) {
  Retelling retelling(problem, engine);
  std::string done;
  for (std::size_t times = 1 + static_cast<std::size_t>(engine() % 2); times > 0; --times)
    done += retelling.one() + ", ";
  return done;
}

}  // namespace pal::test
