#include "tests/run/compiled/follow.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "analyzer/machine/machine.hpp"
#include "analyzer/runs/concrete_run.hpp"
#include "pal/trace/kind.hpp"

namespace pal::test {

using namespace analyzer;

namespace {

/// What is compared of an event: serial numbers are counted otherwise.
using Seen = std::tuple<trace::Kind, int, int, int, int>;

Seen seen(const trace::Event& event) {
  const bool valued = event.kind == trace::Kind::set || event.kind == trace::Kind::read ||
                      event.kind == trace::Kind::complete;
  return {event.kind, event.actor, event.statement, event.subject, valued ? event.value : 0};
}

/// The machine does not follow unrequested frames to their end, and what costs nothing may start
/// without a word.
bool compared(trace::Kind kind) {
  switch (kind) {
    case trace::Kind::idle:
    case trace::Kind::ready:
    case trace::Kind::start:
      return false;
    default:
      return true;
  }
}

struct Instant {
  Nanoseconds at = 0;
  std::vector<Seen> events;  // sorted
};

std::vector<Instant> instants_of(const trace::Trace& run) {
  std::vector<Instant> instants{{0, {}}};
  for (const trace::Event& event : run.events) {
    if (event.time_ns > instants.back().at) instants.push_back({event.time_ns, {}});
    if (!compared(event.kind)) continue;
    instants.back().events.push_back(seen(event));
  }
  for (Instant& each : instants) std::sort(each.events.begin(), each.events.end());
  return instants;
}

class Search {
 public:
  Search(const Machine& machine, std::vector<Instant> instants, runtime::CostPolicy costs)
      : machine_(machine), instants_(std::move(instants)), costs_(costs) {}

  std::string search() {
    AllChoices choices;
    do {
      ConcreteRun run(machine_);
      run.begin(choices);
      std::vector<Seen> left = instants_.front().events;
      fix_costs(run);
      if (take(run, left) && go_on(std::move(run), 0, std::move(left))) return {};
    } while (choices.next() && !gave_up());
    const Instant& at = instants_[furthest_];
    std::string text = gave_up() ? "gave up looking" : "cannot follow";
    text += " at instant " + std::to_string(furthest_) + ", " + std::to_string(at.at) + " ns, of";
    for (const Seen& each : at.events)
      text += " " + std::string(trace::name(std::get<0>(each))) + "(" + std::to_string(std::get<1>(each)) +
              "," + std::to_string(std::get<2>(each)) + "," + std::to_string(std::get<3>(each)) + ")";
    return text;
  }

 private:
  bool gave_up() const { return fired_ > 20'000; }

  /// Statements and messages take just their worst or best time.
  void fix_costs(ConcreteRun& run) const {
    if (costs_ == runtime::CostPolicy::random) return;
    for (const int started : run.started()) {
      if (started >= machine_.next_timer(analyzer::DeviceId{0})) continue;
      Range& range = run.timers()[static_cast<std::size_t>(started)].range;
      (costs_ == runtime::CostPolicy::worst ? range.best : range.worst) =
          costs_ == runtime::CostPolicy::worst ? range.worst : range.best;
    }
  }

  /// Takes what the last firing brought about out of `left`; false: it brought about something else.
  static bool take(const ConcreteRun& run, std::vector<Seen>& left) {
    for (const trace::Event& event : run.outcome().events) {
      if (!compared(event.kind)) continue;
      const auto found = std::lower_bound(left.begin(), left.end(), seen(event));
      if (found == left.end() || *found != seen(event)) return false;
      left.erase(found);
    }
    return true;
  }

  /// The first instant at which a timer must fire.
  Nanoseconds deadline(const ConcreteRun& run) const {
    Nanoseconds first = Range::unbounded;
    for (std::size_t t = 0; t < run.timers().size(); ++t) {
      const ConcreteRun::Timer& timer = run.timers()[t];
      if (!timer.active || timer.frozen || timer.range.worst >= Range::unbounded) continue;
      first = std::min(first, run.now() + timer.range.worst - run.worked(static_cast<int>(t), run.now()));
    }
    return first;
  }

  /// `left`: what instant `number` has still to show. A timer that fires unseen does so at its deadline, or
  /// at an instant at which something happens: at others it is unknown.
  bool go_on(ConcreteRun run, std::size_t number, std::vector<Seen> left) {
    if (gave_up()) return false;
    furthest_ = std::max(furthest_, number);
    if (!left.empty()) return fire_any(run, number, left, instants_[number].at);
    if (number + 1 == instants_.size()) return true;
    const Nanoseconds due = deadline(run);
    const bool forced = due < instants_[number + 1].at;
    if (forced ? fire_any(run, number, left, due) : go_on(run, number + 1, instants_[number + 1].events))
      return true;
    return !(forced && due == instants_[number].at) && fire_any(run, number, left, instants_[number].at);
  }

  bool fire_any(const ConcreteRun& run, std::size_t number, const std::vector<Seen>& left, Nanoseconds at) {
    for (std::size_t t = 0; t < run.timers().size(); ++t) {
      const ConcreteRun::Timer& timer = run.timers()[t];
      if (!timer.active || timer.frozen || run.worked(static_cast<int>(t), at) < timer.range.best) continue;
      AllChoices choices;
      do {
        if (gave_up()) return false;
        ++fired_;
        ConcreteRun next = run;
        if (!next.fire(static_cast<int>(t), at, choices)) continue;
        fix_costs(next);
        std::vector<Seen> rest = left;
        if (take(next, rest) && go_on(std::move(next), number, std::move(rest))) return true;
      } while (choices.next());
    }
    return false;
  }

  const Machine& machine_;
  std::vector<Instant> instants_;
  runtime::CostPolicy costs_;
  std::size_t furthest_ = 0;
  std::size_t fired_ = 0;
};

}  // namespace

std::string not_followed(const Problem& problem, const trace::Trace& run, runtime::CostPolicy costs) {
  const Watch watch;
  const Machine machine(problem, watch);
  return Search(machine, instants_of(run), costs).search();
}

}  // namespace pal::test
