#include "analyzer/compositional/causes/refusal.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/causes/protocol.hpp"

namespace pal::analyzer::compositional {
namespace {

const std::string& name_of(const Problem& problem, ThreadId thread) {
  return problem.threads[thread].name;
}

/// The times of a block within a block depend on jobs of several threads.
bool is_nested(const Problem& problem, ThreadId thread) {
  const ThreadId parent = problem.threads[thread].parent;
  return parent.valid() && problem.threads[parent].parent.valid();
}

/// Blocks that start repeatedly at unknown times, or are stopped in each job.
bool starts_loops_again(const Problem& problem, StepId fork, ThreadId thread) {
  const std::vector<ThreadId>& blocks = problem.steps[fork].threads;
  const bool straight = std::all_of(blocks.begin(), blocks.end(), [&problem](ThreadId block) {
    return problem.threads[block].can_end && ends_straight(problem, block);
  });
  return !straight && recurrent(problem, {Beginning::Kind::joined, thread, fork, -1});
}

/// Whether a block does more than compute: where that stands in a block within a block nothing is known of
/// when.
bool talks_or_sets(const Step& step) {
  return step.kind == Step::Kind::wait || step.kind == Step::Kind::send || step.kind == Step::Kind::set;
}

/// A channel from which several waits take, if there is one. Requests of modules are served wherever their
/// server is. Of an answer it is known which wait takes it. Of other messages this is unknown. What a device
/// sends by itself, be it called a request, may come between two of them.
ChannelId taken_anywhere(const Problem& problem, const Segments& segments) {
  Table<ChannelId, int> waits(problem.channels.size());
  for (const StepId s : problem.steps.ids()) {
    if (problem.steps[s].kind != Step::Kind::wait || !segments.owner(s).valid()) continue;
    for (ChannelId channel : problem.steps[s].channels) {
      const Channel& of = problem.channels[channel];
      const bool asked = of.answer.valid() && !of.sender_device.valid();
      if (!asked && !of.answers.valid() && ++waits[channel] > 1) return channel;
    }
  }
  return ChannelId{};
}

/// The limit starts again when the message that the thread is about to take is withdrawn. Others may take it,
/// too.
bool limits_service(const Problem& problem, const Step& step) {
  return step.kind == Step::Kind::wait && step.within &&
         std::any_of(step.channels.begin(), step.channels.end(),
                     [&problem](ChannelId channel) { return problem.channels[channel].answer.valid(); });
}

/// Why nothing can be said of a skill that has this step, or nothing.
Why refusal_of_step(const Problem& problem, StepId index, ThreadId thread, const SetAside& set_aside) {
  const Step& step = problem.steps[index];
  const std::string& who = name_of(problem, thread);
  if (!set_aside.has(Withheld::loops_again) && step.kind == Step::Kind::fork &&
      starts_loops_again(problem, index, thread))
    return why(Withheld::loops_again, who);
  if (!set_aside.has(Withheld::nested_block) && talks_or_sets(step) && is_nested(problem, thread))
    return why(Withheld::nested_block, who);
  if (!set_aside.has(Withheld::limited_service) && limits_service(problem, step))
    return why(Withheld::limited_service, who);
  return {};
}

/// Whether a request may stay without an answer: then a wait for it has no end of its own.
bool may_fail(const Device& device) {
  const auto* request = std::get_if<pan::RequestDevice>(&device.behaviour);
  return request != nullptr && request->may_fail && !device.requests.empty();
}

}  // namespace

Why refusal_of(const Problem& problem, const Segments& segments, const std::function<bool()>& stop,
               const SetAside& set_aside) {
  for (const Device& device : problem.devices) {
    if (!set_aside.has(Withheld::may_not_answer) && may_fail(device))
      return why(Withheld::may_not_answer, device.name);
  }
  bool over = false;
  const auto ends = [&stop, &over] { return over = over || (stop && stop()); };
  for (const StepId s : problem.steps.ids()) {
    const ThreadId thread = segments.owner(s);
    if (!thread.valid()) continue;
    if (problem.steps[s].kind == Step::Kind::fork && ends()) return why(Withheld::interrupted);
    if (Why found = refusal_of_step(problem, s, thread, set_aside); !found.empty()) return found;
  }
  const ChannelId channel = taken_anywhere(problem, segments);
  if (!set_aside.has(Withheld::taken_anywhere) && channel.valid())
    return why(Withheld::taken_anywhere, problem.channels[channel].message);
  Why found = out_of_turn(problem, segments, ends, set_aside);
  return over ? why(Withheld::interrupted) : found;
}

}  // namespace pal::analyzer::compositional
