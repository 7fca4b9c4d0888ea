// The beginning of a run, and what happens next in it.
#include "tests/support/runs/all_runs.hpp"

#include <algorithm>

namespace pal::test {

using namespace pan;
using namespace runs;

int AllRuns::draw(Interval interval) {
  const int best = static_cast<int>(interval.best / unit_);
  const int worst = static_cast<int>(interval.worst / unit_);
  return best == worst ? best : best + decisions_->pick(worst - best + 1);
}

Interval AllRuns::cost_of(const Thread& thread) const {
  const auto& content = node(thread).content;
  const Costs& costs = environment_.costs;
  if (std::holds_alternative<Wait>(content)) return thread.gives_up ? costs.test : costs.receive;
  if (std::holds_alternative<Send>(content) || std::holds_alternative<Complete>(content)) return costs.send;
  if (std::holds_alternative<Set>(content)) return costs.set;
  if (std::holds_alternative<Read>(content)) return costs.read;
  if (const auto* perform = std::get_if<Perform>(&content)) {
    const Activity& activity = network_.activities[perform->activity.index()];
    const std::string& module = network_.modules[activity.module.index()].name;
    Interval anywhere{};
    for (const ActivityTime& time : environment_.activities) {
      if (time.activity != activity.name) continue;
      if (time.module == module) return time.time;
      if (time.module.empty()) anywhere = time.time;
    }
    return anywhere;
  }
  return costs.test;
}

/// What the environment says of the longest end of a name; nothing: the thread is where `runner` is.
void AllRuns::place(Thread& thread, const std::string& name, int runner) const {
  const Placement* found = nullptr;
  for (const Placement& each : environment_.placements) {
    const bool meant = name == each.thread || name.ends_with("/" + each.thread);
    if (meant && (found == nullptr || each.thread.size() > found->thread.size())) found = &each;
  }
  if (found == nullptr) {
    thread.processor = s_.threads[ix(runner)].processor;
    thread.priority = s_.threads[ix(runner)].priority;
    return;
  }
  for (std::size_t p = 0; p < environment_.processors.size(); ++p) {
    if (environment_.processors[p].name == found->processor) thread.processor = static_cast<int>(p);
  }
  thread.priority = found->priority;
}

std::string AllRuns::who(int thread) const {
  return thread < 0 ? "-" : names_.at(thread);
}

void AllRuns::say(const std::string& what) {
  if (telling_) story.push_back(std::to_string(now_) + " " + what);
}

void AllRuns::later(std::function<void()> what) {
  due_.push_back(std::move(what));
}

/// What follows at one instant from what has happened at it, in every order.
void AllRuns::all_due() {
  while (!due_.empty() && !s_.ended) {
    const int chosen = due_.size() == 1 ? 0 : decisions_->pick(static_cast<int>(due_.size()));
    const std::function<void()> next = due_[ix(chosen)];
    due_.erase(due_.begin() + chosen);
    next();
  }
  due_.clear();
}

void AllRuns::any_order(std::vector<int> of, const std::function<void(int)>& each) {
  while (!of.empty() && !s_.ended) {
    const int chosen = of.size() == 1 ? 0 : decisions_->pick(static_cast<int>(of.size()));
    const int next = of[ix(chosen)];
    of.erase(of.begin() + chosen);
    each(next);
  }
}

void AllRuns::begin() {
  s_ = {};
  now_ = 0;
  s_.running.assign(environment_.processors.size(), -1);
  s_.queues.resize(environment_.processors.size());
  s_.slots.resize(network_.channels.size());
  s_.busy.assign(environment_.processors.size(), -1);
  s_.known.assign(network_.conditions.size(), -1);
  s_.devices.resize(processes_.size());
  for (std::size_t p = 0; p < processes_.size(); ++p) {
    if (processes_[p].timing == nullptr) continue;
    const auto* frames = std::get_if<FrameDevice>(&processes_[p].timing->behaviour);
    if (frames == nullptr) continue;
    // Phases in [0, T): T itself is 0 with the first frame lost, which is a run as well.
    s_.devices[p].next =
        frames->phase ? draw({*frames->phase, *frames->phase}) : draw({Duration(0), frames->period - unit_});
  }
  std::vector<int> modules;
  for (std::size_t m = 0; m < network_.modules.size(); ++m) {
    const Module& module = network_.modules[m];
    if (module.body.empty() || module.executed_by.valid()) continue;
    Thread made;
    made.at = {{static_cast<int>(m), 0}};
    made.module = static_cast<int>(m);
    place(made, module.name, -1);
    const int index = static_cast<int>(s_.threads.size());
    known_threads_[{-1, made.at}] = index;
    names_[index] = module.name;
    made.status = Status::ready;
    s_.threads.push_back(made);
    modules.push_back(index);
  }
  begin_measuring();
  any_order(modules, [this](int thread) {
    walk_on(thread);
    all_due();
  });
  dispatch();
  track_busy();
  canonical(s_);
}

bool AllRuns::step() {
  if (s_.ended || s_.failed) return false;
  enum class What { work, limit, near, far, next, late, service };
  std::vector<std::pair<What, int>> first;
  int least = -1;
  const auto due = [&](What what, int which, int left) {
    if (left < 0) return;
    if (least >= 0 && left > least) return;
    if (left < least) first.clear();
    least = left;
    first.push_back({what, which});
  };
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    const Thread& thread = s_.threads[t];
    if (thread.status == Status::running && thread.begun) due(What::work, static_cast<int>(t), thread.left);
    if (thread.status == Status::waiting) due(What::limit, static_cast<int>(t), thread.limit);
  }
  for (std::size_t c = 0; c < s_.slots.size(); ++c) {
    due(What::near, static_cast<int>(c), s_.slots[c].near);
    due(What::far, static_cast<int>(c), s_.slots[c].far);
  }
  for (std::size_t d = 0; d < s_.devices.size(); ++d) {
    const Device& device = s_.devices[d];
    // A frame ends before the next one starts.
    const bool frame = device.service >= 0 && processes_[d].timing != nullptr &&
                       std::holds_alternative<FrameDevice>(processes_[d].timing->behaviour);
    if (!frame || device.next < device.service) due(What::next, static_cast<int>(d), device.next);
    due(What::late, static_cast<int>(d), device.late);
    due(What::service, static_cast<int>(d), device.service);
  }
  if (first.empty()) return false;
  passed_ = least;
  pass(least);
  const auto [what, which] =
      first[ix(first.size() == 1 ? 0 : decisions_->pick(static_cast<int>(first.size())))];
  switch (what) {
    case What::work:
      effect(which);
      break;
    case What::limit: {
      Thread& thread = s_.threads[ix(which)];
      say(who(which) + " gives up");
      thread.limit = -1;
      thread.gives_up = true;
      ready(which);
      break;
    }
    case What::near:
      s_.slots[ix(which)].near = -1;
      offer(which);
      break;
    case What::far:
      s_.slots[ix(which)].far = -1;
      offer(which);
      break;
    case What::next:
      if (std::holds_alternative<FrameDevice>(processes_[ix(which)].timing->behaviour)) {
        frame(which);
      } else {
        event(which);
      }
      break;
    case What::late:
      s_.devices[ix(which)].late = -1;
      occurs(which);
      break;
    case What::service:
      answer(which);
      break;
  }
  all_due();
  if (!s_.ended) dispatch();
  track_busy();
  canonical(s_);
  return true;
}

void AllRuns::pass(int time) {
  now_ += time;
  for (Thread& thread : s_.threads) {
    if (thread.status == Status::running && thread.begun) thread.left -= time;
    if (thread.status == Status::waiting && thread.limit >= 0) thread.limit -= time;
  }
  for (Slot& slot : s_.slots) {
    if (slot.near >= 0) slot.near -= time;
    if (slot.far >= 0) slot.far -= time;
  }
  for (Device& device : s_.devices) {
    if (device.next >= 0) device.next -= time;
    if (device.late >= 0) device.late -= time;
    if (device.service >= 0) device.service -= time;
  }
  grow(time);
}

/// What is the same in what can still happen is written in the same way.
void AllRuns::canonical(State& state) const {
  for (Thread& thread : state.threads) {
    if (thread.status == Status::off) continue;
    if (thread.status != Status::waiting) thread.limit = -1;
    if (!thread.begun) thread.left = 0;
    thread.latched_true &= thread.latched;
  }
  forget(state);
}

}  // namespace pal::test
