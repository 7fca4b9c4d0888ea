#include "analyzer/slice/talk.hpp"

#include <algorithm>

#include "analyzer/machine/watch.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer {
namespace {

/// Of `steps` those on a way round, or between two ways round: what is left when all are taken away to which
/// nothing leads.
std::vector<bool> again(const Problem& problem, const std::vector<int>& steps) {
  std::vector<int> entering(problem.steps.size());
  for (const int s : steps) {
    for (const int next : problem.steps[static_cast<std::size_t>(s)].next)
      ++entering[static_cast<std::size_t>(next)];
  }
  std::vector<int> open;
  for (const int s : steps) {
    if (entering[static_cast<std::size_t>(s)] == 0) open.push_back(s);
  }
  std::vector<bool> left(problem.steps.size());
  for (const int s : steps) left[static_cast<std::size_t>(s)] = true;
  while (!open.empty()) {
    const int s = open.back();
    open.pop_back();
    left[static_cast<std::size_t>(s)] = false;
    for (const int next : problem.steps[static_cast<std::size_t>(s)].next) {
      if (--entering[static_cast<std::size_t>(next)] == 0) open.push_back(next);
    }
  }
  return left;
}

/// Of `steps` those from which a way round can still be reached, or that lie on one.
std::vector<bool> before_round(const Problem& problem, const std::vector<int>& steps) {
  std::vector<std::vector<int>> before(problem.steps.size());
  std::vector<int> leaving(problem.steps.size());
  for (const int s : steps) {
    for (const int next : problem.steps[static_cast<std::size_t>(s)].next) {
      before[static_cast<std::size_t>(next)].push_back(s);
      ++leaving[static_cast<std::size_t>(s)];
    }
  }
  std::vector<bool> left(problem.steps.size());
  std::vector<int> open;
  for (const int s : steps) {
    left[static_cast<std::size_t>(s)] = true;
    if (leaving[static_cast<std::size_t>(s)] == 0) open.push_back(s);
  }
  while (!open.empty()) {
    const int s = open.back();
    open.pop_back();
    left[static_cast<std::size_t>(s)] = false;
    for (const int earlier : before[static_cast<std::size_t>(s)]) {
      if (--leaving[static_cast<std::size_t>(earlier)] == 0) open.push_back(earlier);
    }
  }
  return left;
}

/// Steps that may come after blocks.
std::vector<bool> behind_blocks(const Problem& problem, const std::vector<int>& steps) {
  std::vector<bool> found(problem.steps.size());
  std::vector<int> forks;
  for (const int s : steps) {
    if (problem.steps[static_cast<std::size_t>(s)].kind == Step::Kind::fork) forks.push_back(s);
  }
  follow(problem, forks, [&found](int at) {
    found[static_cast<std::size_t>(at)] = true;
    return Course::goes_on;
  });
  return found;
}

void note(const Problem& problem, const Step& step, bool again, ThreadTalk& talk) {
  if (step.kind == Step::Kind::send) {
    talk.sends.insert(step.channels.front());
    if (again) talk.sends_again.insert(step.channels.front());
  }
  if (step.kind == Step::Kind::wait) {
    talk.waits.insert(step.channels.begin(), step.channels.end());
    if (again) talk.waits_again.insert(step.channels.begin(), step.channels.end());
  }
  if (step.kind == Step::Kind::fork) {
    talk.blocks.insert(step.threads.begin(), step.threads.end());
    if (again) talk.blocks_again.insert(step.threads.begin(), step.threads.end());
  }
  for (const ChannelId channel : step.kind == Step::Kind::wait ? step.channels : std::vector<ChannelId>()) {
    const KeptId kept = problem.channels[channel].kept;
    if (kept.valid()) talk.keeps.insert(kept);
  }
  talk.keeps.insert(step.writes.begin(), step.writes.end());
  talk.uses.insert(step.uses.begin(), step.uses.end());
  if (step.kind == Step::Kind::set) talk.sets.insert(step.condition);
  if (step.kind == Step::Kind::read) talk.reads.insert(step.condition);
  for (const ConditionId c : problem.conditions.ids()) {
    if (tests(step, c)) talk.reads.insert(c);
  }
}

}  // namespace

std::vector<ThreadTalk> talk_of(const Problem& problem) {
  std::vector<ThreadTalk> all(problem.threads.size());
  for (std::size_t t = 0; t < all.size(); ++t) {
    const std::set<int> steps = steps_of(problem, problem.threads[t]);
    all[t].steps.assign(steps.begin(), steps.end());
    const std::vector<bool> behind = again(problem, all[t].steps);
    const std::vector<bool> ahead = before_round(problem, all[t].steps);
    const std::vector<bool> later = behind_blocks(problem, all[t].steps);
    for (const int s : all[t].steps) {
      const auto at = static_cast<std::size_t>(s);
      if (!behind[at] && !later[at]) all[t].beginning.push_back(s);
      note(problem, problem.steps[at], behind[at] && ahead[at], all[t]);
    }
  }
  return all;
}

Nanoseconds least_wait(const Problem& problem, const std::vector<ThreadTalk>& talk, int thread, int step) {
  const Step& wait = problem.steps[static_cast<std::size_t>(step)];
  if (wait.kind != Step::Kind::wait || wait.within || wait.channels.size() != 1) return 0;
  const ChannelId answer = wait.channels.front();
  const Channel& of = problem.channels[answer];
  if (!of.sender_device.valid() || !of.answers.valid()) return 0;
  for (std::size_t t = 0; t < talk.size(); ++t) {
    const bool uses = talk[t].sends.contains(of.answers) || talk[t].waits.contains(answer);
    if (uses && static_cast<int>(t) != thread) return 0;
  }
  // It asks and waits by turns: each answer is that of the request just before it.
  const auto waits = [&](int s) {
    const Step& each = problem.steps[static_cast<std::size_t>(s)];
    return each.kind == Step::Kind::wait && each.channels == wait.channels && !each.within;
  };
  const ThreadTalk& own = talk[static_cast<std::size_t>(thread)];
  for (const int s : own.steps) {
    const Step& each = problem.steps[static_cast<std::size_t>(s)];
    const bool asks = each.kind == Step::Kind::send && each.channels.front() == of.answers;
    if (asks && !waits(each.next.front())) return 0;
    const bool takes_so =
        each.kind == Step::Kind::wait &&
        std::find(each.channels.begin(), each.channels.end(), answer) != each.channels.end();
    if (takes_so && !waits(s)) return 0;
    for (const int next : each.next) {
      if (waits(next) && !asks) return 0;
    }
  }
  if (waits(problem.threads[static_cast<std::size_t>(thread)].entry)) return 0;
  const auto& behaviour = problem.devices[of.sender_device].behaviour;
  if (const auto* request = std::get_if<pan::RequestDevice>(&behaviour)) return request->answer.best.count();
  if (const auto* frames = std::get_if<pan::FrameDevice>(&behaviour)) return frames->collecting.count();
  return 0;
}

}  // namespace pal::analyzer
