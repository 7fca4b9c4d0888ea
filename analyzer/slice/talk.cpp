#include "analyzer/slice/talk.hpp"

#include <algorithm>

#include "analyzer/machine/watch.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer {
namespace {

/// Of `steps` those on a way round, or between two ways round: what is left when all are taken away to which
/// nothing leads.
Table<StepId, bool> again(const Problem& problem, const std::vector<StepId>& steps) {
  Table<StepId, int> entering(problem.steps.size());
  for (const StepId s : steps) {
    for (const StepId next : problem.steps[s].next) ++entering[next];
  }
  std::vector<StepId> open;
  for (const StepId s : steps) {
    if (entering[s] == 0) open.push_back(s);
  }
  Table<StepId, bool> left(problem.steps.size());
  for (const StepId s : steps) left[s] = true;
  while (!open.empty()) {
    const StepId s = open.back();
    open.pop_back();
    left[s] = false;
    for (const StepId next : problem.steps[s].next) {
      if (--entering[next] == 0) open.push_back(next);
    }
  }
  return left;
}

/// Of `steps` those from which a way round can still be reached, or that lie on one.
Table<StepId, bool> before_round(const Problem& problem, const std::vector<StepId>& steps) {
  Table<StepId, std::vector<StepId>> before(problem.steps.size());
  Table<StepId, int> leaving(problem.steps.size());
  for (const StepId s : steps) {
    for (const StepId next : problem.steps[s].next) {
      before[next].push_back(s);
      ++leaving[s];
    }
  }
  Table<StepId, bool> left(problem.steps.size());
  std::vector<StepId> open;
  for (const StepId s : steps) {
    left[s] = true;
    if (leaving[s] == 0) open.push_back(s);
  }
  while (!open.empty()) {
    const StepId s = open.back();
    open.pop_back();
    left[s] = false;
    for (const StepId earlier : before[s]) {
      if (--leaving[earlier] == 0) open.push_back(earlier);
    }
  }
  return left;
}

/// Steps that may come after blocks.
Table<StepId, bool> behind_blocks(const Problem& problem, const std::vector<StepId>& steps) {
  Table<StepId, bool> found(problem.steps.size());
  std::vector<StepId> forks;
  for (const StepId s : steps) {
    if (problem.steps[s].kind == Step::Kind::fork) forks.push_back(s);
  }
  follow(problem, forks, [&found](StepId at) {
    found[at] = true;
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

Table<ThreadId, ThreadTalk> talk_of(const Problem& problem) {
  Table<ThreadId, ThreadTalk> all(problem.threads.size());
  for (const ThreadId t : all.ids()) {
    const std::set<StepId> steps = steps_of(problem, problem.threads[t]);
    all[t].steps.assign(steps.begin(), steps.end());
    const Table<StepId, bool> behind = again(problem, all[t].steps);
    const Table<StepId, bool> ahead = before_round(problem, all[t].steps);
    const Table<StepId, bool> later = behind_blocks(problem, all[t].steps);
    for (const StepId s : all[t].steps) {
      if (!behind[s] && !later[s]) all[t].beginning.push_back(s);
      note(problem, problem.steps[s], behind[s] && ahead[s], all[t]);
    }
  }
  return all;
}

Nanoseconds least_wait(const Problem& problem, const Table<ThreadId, ThreadTalk>& talk, ThreadId thread,
                       StepId step) {
  const Step& wait = problem.steps[step];
  if (wait.kind != Step::Kind::wait || wait.within || wait.channels.size() != 1) return 0;
  const ChannelId answer = wait.channels.front();
  const Channel& of = problem.channels[answer];
  if (!of.sender_device.valid() || !of.answers.valid()) return 0;
  for (const ThreadId t : talk.ids()) {
    const bool uses = talk[t].sends.contains(of.answers) || talk[t].waits.contains(answer);
    if (uses && t != thread) return 0;
  }
  // It asks and waits by turns: each answer is that of the request just before it.
  const auto waits = [&](StepId s) {
    const Step& each = problem.steps[s];
    return each.kind == Step::Kind::wait && each.channels == wait.channels && !each.within;
  };
  const ThreadTalk& own = talk[thread];
  for (const StepId s : own.steps) {
    const Step& each = problem.steps[s];
    const bool asks = each.kind == Step::Kind::send && each.channels.front() == of.answers;
    if (asks && !waits(each.next.front())) return 0;
    const bool takes_so =
        each.kind == Step::Kind::wait &&
        std::find(each.channels.begin(), each.channels.end(), answer) != each.channels.end();
    if (takes_so && !waits(s)) return 0;
    for (const StepId next : each.next) {
      if (waits(next) && !asks) return 0;
    }
  }
  if (waits(problem.threads[thread].entry)) return 0;
  const auto& behaviour = problem.devices[of.sender_device].behaviour;
  if (const auto* request = std::get_if<pan::RequestDevice>(&behaviour)) return request->answer.best.count();
  if (const auto* frames = std::get_if<pan::FrameDevice>(&behaviour)) return frames->collecting.count();
  return 0;
}

}  // namespace pal::analyzer
