#include "analyzer/whatif/candidates.hpp"

#include <algorithm>
#include <optional>

#include "pal/support/duration_text.hpp"

namespace pal::analyzer::whatif {
namespace {

/// By how much a period is made longer, in quarters.
constexpr Nanoseconds quarters[] = {5, 6, 8, 16};

class Candidates {
 public:
  Candidates(const Problem& problem, const pan::Environment& environment)
      : problem_(problem), environment_(environment) {}

  std::vector<Changes> all() {
    for (const Thread& thread : problem_.threads) reorder(thread);
    for (const Thread& thread : problem_.threads) move(thread);
    for (const Device& device : problem_.devices) slow_down(device);
    return std::move(found_);
  }

 private:
  std::vector<const Thread*> beside(const Thread& thread) const {
    std::vector<const Thread*> others;
    for (const Thread& other : problem_.threads) {
      if (&other != &thread && other.processor == thread.processor) others.push_back(&other);
    }
    return others;
  }

  /// Before all others of its processor, and behind them.
  void reorder(const Thread& thread) {
    const auto others = beside(thread);
    if (others.empty()) return;
    int least = others.front()->priority;
    int greatest = least;
    for (const Thread* other : others) {
      least = std::min(least, other->priority);
      greatest = std::max(greatest, other->priority);
    }
    const auto give = [&](int priority) {
      found_.push_back({{Change::Kind::priority, thread.name, std::to_string(priority)}});
    };
    if (thread.priority <= greatest) give(greatest + 1);
    if (thread.priority >= least && least > 0) give(least - 1);
  }

  bool is_used(const pan::Processor& processor) const {
    return std::any_of(problem_.threads.begin(), problem_.threads.end(), [&](const Thread& thread) {
      return problem_.processors[thread.processor].name == processor.name;
    });
  }

  void move(const Thread& thread) {
    const auto on = [&](const std::string& processor) {
      return Change{Change::Kind::processor, thread.name, processor};
    };
    const std::string& own = problem_.processors[thread.processor].name;
    const bool alone = beside(thread).empty();
    bool free = false;
    for (const pan::Processor& processor : environment_.processors) {
      const bool used = is_used(processor);
      // The first processor without a thread stands for all of them. A thread that is alone gains nothing
      // there.
      if (processor.name == own || (!used && (free || alone))) continue;
      free = free || !used;
      found_.push_back({on(processor.name)});
    }
    if (free || alone) return;
    const std::string more = new_processor();
    found_.push_back({{Change::Kind::new_processor, more, ""}, on(more)});
  }

  std::string new_processor() const {
    for (std::size_t number = environment_.processors.size();; ++number) {
      const std::string name = "P" + std::to_string(number);
      const auto same = [&](const pan::Processor& each) { return each.name == name; };
      if (std::none_of(environment_.processors.begin(), environment_.processors.end(), same)) return name;
    }
  }

  void slow_down(const Device& device) {
    std::optional<Duration> period;
    if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour)) period = event->period;
    if (const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour)) period = frames->period;
    if (!period) return;
    for (const Nanoseconds times : quarters)
      found_.push_back({{Change::Kind::period, device.name, to_text(Duration(period->count() * times / 4))}});
  }

  const Problem& problem_;
  const pan::Environment& environment_;
  std::vector<Changes> found_;
};

}  // namespace

std::string text(const Change& change) {
  switch (change.kind) {
    case Change::Kind::new_processor:
      return "PROCESSOR " + change.of;
    case Change::Kind::priority:
      return change.of + ".priority = " + change.value;
    case Change::Kind::processor:
      return change.of + ".processor = " + change.value;
    case Change::Kind::period:
      break;
  }
  return change.of + ".period = " + change.value;
}

std::string words(const Change& change) {
  switch (change.kind) {
    case Change::Kind::new_processor:
      return "add processor " + change.of;
    case Change::Kind::priority:
      return "give " + change.of + " priority " + change.value;
    case Change::Kind::processor:
      return "place " + change.of + " on " + change.value;
    case Change::Kind::period:
      break;
  }
  return "make the period of " + change.of + " " + change.value;
}

std::vector<Changes> candidates_for(const Problem& problem, const pan::Environment& environment) {
  return Candidates(problem, environment).all();
}

}  // namespace pal::analyzer::whatif
