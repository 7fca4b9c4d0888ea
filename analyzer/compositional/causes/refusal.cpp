#include "analyzer/compositional/causes/refusal.hpp"

#include <algorithm>

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/compositional/causes/protocol.hpp"

namespace pal::analyzer::compositional {
namespace {

constexpr const char* interrupted = "it was interrupted";

const std::string& name_of(const Problem& problem, int thread) {
  return problem.threads[static_cast<std::size_t>(thread)].name;
}

/// The times of a block within a block depend on jobs of several threads.
bool is_nested(const Problem& problem, int thread) {
  const int parent = problem.threads[static_cast<std::size_t>(thread)].parent;
  return parent >= 0 && problem.threads[static_cast<std::size_t>(parent)].parent >= 0;
}

/// Blocks that start repeatedly at unknown times, or are stopped in each job.
bool starts_loops_again(const Problem& problem, int fork, int thread) {
  const std::vector<int>& blocks = problem.steps[static_cast<std::size_t>(fork)].threads;
  const bool straight = std::all_of(blocks.begin(), blocks.end(), [&problem](int block) {
    return problem.threads[static_cast<std::size_t>(block)].can_end && ends_straight(problem, block);
  });
  return !straight && recurrent(problem, {Beginning::Kind::joined, thread, fork, -1});
}

/// Whether a block does more than compute: where that stands in a block within a block nothing is known of
/// when.
bool talks_or_sets(const Step& step) {
  return step.kind == Step::Kind::wait || step.kind == Step::Kind::send || step.kind == Step::Kind::set;
}

/// A channel from which several waits take; -1: there is none. Requests of modules are served wherever their
/// server is. Of an answer it is known which wait takes it. Of other messages this is unknown. What a device
/// sends by itself, be it called a request, may come between two of them.
int taken_anywhere(const Problem& problem, const Segments& segments) {
  std::vector<int> waits(problem.channels.size());
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    if (problem.steps[s].kind != Step::Kind::wait || segments.owner(static_cast<int>(s)) < 0) continue;
    for (int channel : problem.steps[s].channels) {
      const Channel& of = problem.channels[static_cast<std::size_t>(channel)];
      const bool asked = of.answer >= 0 && !of.sender_device.valid();
      if (!asked && of.answers < 0 && ++waits[static_cast<std::size_t>(channel)] > 1) return channel;
    }
  }
  return -1;
}

/// Why nothing can be said of a skill that has this step, or nothing.
std::string refusal_of_step(const Problem& problem, int index, int thread) {
  const Step& step = problem.steps[static_cast<std::size_t>(index)];
  const std::string& who = name_of(problem, thread);
  if (step.kind == Step::Kind::fork && starts_loops_again(problem, index, thread))
    return who + " starts blocks again and again, some of which loop";
  if (talks_or_sets(step) && is_nested(problem, thread))
    return who + " waits, sends or sets in a block within a block";
  // The limit starts again when the message that the thread is about to take is withdrawn. Others may take
  // it, too.
  const bool serves = std::any_of(step.channels.begin(), step.channels.end(), [&problem](int channel) {
    return problem.channels[static_cast<std::size_t>(channel)].answer >= 0;
  });
  if (step.kind == Step::Kind::wait && step.within && serves)
    return who + " waits with a limit for a request";
  return {};
}

/// Whether a request may stay without an answer: then a wait for it has no end of its own.
bool may_fail(const Device& device) {
  const auto* request = std::get_if<pan::RequestDevice>(&device.behaviour);
  return request != nullptr && request->may_fail && !device.requests.empty();
}

}  // namespace

std::string refusal_of(const Problem& problem, const Segments& segments, const std::function<bool()>& stop) {
  for (const Device& device : problem.devices) {
    if (may_fail(device)) return device.name + " may not answer a request (OR NEVER)";
  }
  bool over = false;
  const auto ends = [&stop, &over] { return over = over || (stop && stop()); };
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const int step = static_cast<int>(s);
    const int thread = segments.owner(step);
    if (thread < 0) continue;
    if (problem.steps[s].kind == Step::Kind::fork && ends()) return interrupted;
    const std::string why = refusal_of_step(problem, step, thread);
    if (!why.empty()) return why;
  }
  if (const int channel = taken_anywhere(problem, segments); channel >= 0)
    return problem.channels[static_cast<std::size_t>(channel)].message + " is waited for in several places";
  const std::string why = out_of_turn(problem, segments, ends);
  return over ? interrupted : why;
}

}  // namespace pal::analyzer::compositional
