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
class Order {
 public:
  explicit Order(const Problem& problem) : problem_(problem) {}

  bool from(int first) {
    if (stops(at(first))) return true;
    std::vector<std::pair<int, std::size_t>> open{{first, 0}};
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
      const int to = here.next[next++];
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

  std::vector<int> order;

 private:
  const Step& at(int step) const { return problem_.steps[static_cast<std::size_t>(step)]; }
  const Problem& problem_;
  std::map<int, int> mark_;
};

}  // namespace

std::vector<bool> steps_after(const Problem& problem, const Segment& segment, int first) {
  std::vector<bool> inside(problem.steps.size());
  for (const Segment::Passed& passed : segment.steps) inside[static_cast<std::size_t>(passed.step)] = true;
  std::vector<bool> after(problem.steps.size());
  follow(problem, problem.steps[static_cast<std::size_t>(first)].next, [&](int at) {
    const auto here = static_cast<std::size_t>(at);
    after[here] = true;
    return stops(problem.steps[here]) || !inside[here] ? Course::ends : Course::goes_on;
  });
  return after;
}

bool any_in_row(const Problem& problem, const Segment& segment, const std::vector<int>& steps) {
  std::vector<bool> wanted(problem.steps.size());
  for (const int step : steps) wanted[static_cast<std::size_t>(step)] = true;
  // From the last step on: what follows a step of the segment is known before the step itself.
  std::vector<bool> leads_there(problem.steps.size());
  for (auto passed = segment.steps.rbegin(); passed != segment.steps.rend(); ++passed) {
    const auto here = static_cast<std::size_t>(passed->step);
    const std::vector<int>& next = problem.steps[here].next;
    const bool leads = std::any_of(next.begin(), next.end(), [&](int to) {
      const auto there = static_cast<std::size_t>(to);
      return wanted[there] || (leads_there[there] && !stops(problem.steps[there]));
    });
    if (leads && wanted[here]) return true;
    leads_there[here] = leads;
  }
  return false;
}

bool may_end(const Problem& problem, const Segment& segment) {
  return segment.ends ||
         std::any_of(segment.steps.begin(), segment.steps.end(), [&problem](const Segment::Passed& passed) {
           const Step& step = problem.steps[static_cast<std::size_t>(passed.step)];
           return step.kind == Step::Kind::complete || may_match_nothing(step);
         });
}

Segments::Segments(const Problem& problem) : problem_(problem), owner_(problem.steps.size(), -1) {
  for (std::size_t t = 0; t < problem.threads.size(); ++t) {
    for (const int step : steps_of(problem, problem.threads[t])) {
      int& owner = owner_[static_cast<std::size_t>(step)];
      if (owner < 0) owner = static_cast<int>(t);
    }
  }
}

int Segments::find(const Beginning& beginning) {
  const auto [place, made] = known_.emplace(beginning, size());
  if (made) segments_.push_back(make(beginning));
  return place->second;
}

Segment Segments::make(const Beginning& beginning) const {
  Segment segment;
  segment.beginning = beginning;
  const auto step_at = [this](int step) -> const Step& {
    return problem_.steps[static_cast<std::size_t>(step)];
  };
  int first = -1;
  Range before;
  switch (beginning.kind) {
    case Beginning::Kind::entry:
      first = problem_.threads[static_cast<std::size_t>(beginning.thread)].entry;
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
  Order order(problem_);
  if (!order.from(first)) {
    segment.spins = true;
    segment.worst = never;
    return segment;
  }
  std::map<int, Range> reached{{first, before}};
  std::map<int, Range> arrivals;
  const auto reach = [&](int step, Range at) {
    auto& there = stops(step_at(step)) ? arrivals : reached;
    const auto [place, fresh] = there.emplace(step, at);
    if (fresh) return;
    place->second.best = std::min(place->second.best, at.best);
    place->second.worst = std::max(place->second.worst, at.worst);
  };
  if (stops(step_at(first))) reach(first, before);
  for (int step : order.order) {
    const Step& here = step_at(step);
    Range at = reached.at(step);
    at.best = plus(at.best, here.cost.best);
    at.worst = plus(at.worst, here.cost.worst);
    segment.steps.push_back({step, at.best, at.worst});
    segment.worst = std::max(segment.worst, at.worst);
    for (int next : here.next) reach(next, at);
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
