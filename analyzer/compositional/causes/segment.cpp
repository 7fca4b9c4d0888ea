#include "analyzer/compositional/causes/segment.hpp"

#include <algorithm>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

bool stops(const Step& step) {
  return step.kind == Kind::wait || step.kind == Kind::fork || step.kind == Kind::end;
}

/// Steps from `first` on, up to where segments end, each before those that follow it; false: there is a loop.
class StepOrder {
 public:
  explicit StepOrder(const Problem& problem) : problem_(problem) {}

  bool from(StepId first) {
    if (stops(at(first))) return true;
    std::vector<std::pair<StepId, std::size_t>> open{{first, 0}};
    mark_[first] = 1;
    while (!open.empty()) {
      auto& [step, next] = open.back();
      const Step& here = at(step);
      if (next == here.next.size()) {
        mark_[step] = 2;
        order.push_back(step);
        open.pop_back();
        continue;
      }
      const StepId to = here.next[next++];
      if (stops(at(to))) continue;
      const int mark = mark_[to];
      if (mark == 1) return false;
      if (mark == 0) {
        mark_[to] = 1;
        open.emplace_back(to, 0);
      }
    }
    std::reverse(order.begin(), order.end());
    return true;
  }

  std::vector<StepId> order;

 private:
  const Step& at(StepId step) const { return problem_.steps[step]; }
  const Problem& problem_;
  std::map<StepId, int> mark_;
};

}  // namespace

Table<StepId, bool> steps_after(const Problem& problem, const Segment& segment, StepId first) {
  Table<StepId, bool> inside(problem.steps.size());
  for (const Segment::Passed& passed : segment.steps) inside[passed.step] = true;
  Table<StepId, bool> after(problem.steps.size());
  follow(problem, problem.steps[first].next, [&](StepId at) {
    after[at] = true;
    return stops(problem.steps[at]) || !inside[at] ? Course::ends : Course::goes_on;
  });
  return after;
}

bool any_in_row(const Problem& problem, const Segment& segment, const std::vector<StepId>& steps) {
  Table<StepId, bool> wanted(problem.steps.size());
  for (const StepId step : steps) wanted[step] = true;
  // From the last step on: what follows a step of the segment is known before the step itself.
  Table<StepId, bool> leads_there(problem.steps.size());
  for (auto passed = segment.steps.rbegin(); passed != segment.steps.rend(); ++passed) {
    const StepId here = passed->step;
    const std::vector<StepId>& next = problem.steps[here].next;
    const bool leads = std::any_of(next.begin(), next.end(), [&](StepId to) {
      return wanted[to] || (leads_there[to] && !stops(problem.steps[to]));
    });
    if (leads && wanted[here]) return true;
    leads_there[here] = leads;
  }
  return false;
}

bool may_end(const Problem& problem, const Segment& segment) {
  return segment.ends ||
         std::any_of(segment.steps.begin(), segment.steps.end(), [&problem](const Segment::Passed& passed) {
           const Step& step = problem.steps[passed.step];
           return step.kind == Step::Kind::complete || may_match_nothing(step);
         });
}

Segments::Segments(const Problem& problem) : problem_(problem), owner_(problem.steps.size()) {
  for (const ThreadId t : problem.threads.ids()) {
    for (const StepId step : steps_of(problem, problem.threads[t])) {
      ThreadId& owner = owner_[step];
      if (!owner.valid()) owner = t;
    }
  }
}

SegmentId Segments::find(const Beginning& beginning) {
  const auto [place, made] = known_.emplace(beginning, size());
  if (made) segments_.push_back(make(beginning));
  return place->second;
}

Segment Segments::make(const Beginning& beginning) const {
  Segment segment;
  segment.beginning = beginning;
  const auto step_at = [this](StepId step) -> const Step& { return problem_.steps[step]; };
  StepId first{};
  Range before;
  switch (beginning.kind) {
    case Beginning::Kind::entry:
      first = problem_.threads[beginning.thread].entry;
      break;
    case Beginning::Kind::joined:
      first = step_at(beginning.step).next.front();
      break;
    case Beginning::Kind::arm:
      first = step_at(beginning.step).next[static_cast<std::size_t>(beginning.arm)];
      before = step_at(beginning.step).cost;
      break;
    case Beginning::Kind::give_up:
      first = step_at(beginning.step).next.back();
      before = step_at(beginning.step).give_up_cost;
      break;
  }
  const bool after_wait =
      beginning.kind == Beginning::Kind::arm || beginning.kind == Beginning::Kind::give_up;
  if (after_wait) segment.steps.push_back({beginning.step, before.best, before.worst});
  segment.worst = before.worst;
  StepOrder order(problem_);
  if (!order.from(first)) {
    segment.spins = true;
    segment.worst = never;
    return segment;
  }
  std::map<StepId, Range> reached{{first, before}};
  std::map<StepId, Range> arrivals;
  const auto reach = [&](StepId step, Range at) {
    auto& there = stops(step_at(step)) ? arrivals : reached;
    const auto [place, fresh] = there.emplace(step, at);
    if (fresh) return;
    place->second.best = std::min(place->second.best, at.best);
    place->second.worst = std::max(place->second.worst, at.worst);
  };
  if (stops(step_at(first))) reach(first, before);
  for (StepId step : order.order) {
    const Step& here = step_at(step);
    Range at = reached.at(step);
    at.best = plus(at.best, here.cost.best);
    at.worst = plus(at.worst, here.cost.worst);
    segment.steps.push_back({step, at.best, at.worst});
    segment.worst = std::max(segment.worst, at.worst);
    for (StepId next : here.next) reach(next, at);
  }
  for (const auto& [step, at] : arrivals) {
    const Segment::Arrival arrival{step, at.best, at.worst};
    if (step_at(step).kind == Kind::wait) segment.waits.push_back(arrival);
    if (step_at(step).kind == Kind::fork) segment.forks.push_back(arrival);
    if (step_at(step).kind == Kind::end) segment.ends = true;
  }
  return segment;
}

}  // namespace pal::analyzer::compositional
