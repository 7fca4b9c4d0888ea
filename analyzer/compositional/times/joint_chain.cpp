#include "analyzer/compositional/times/joint_chain.hpp"

#include <algorithm>

#include "analyzer/compositional/times/inter_arrival.hpp"
#include "analyzer/compositional/times/slots.hpp"

namespace pal::analyzer::compositional {
namespace {

constexpr std::size_t most_in_chain = 8;

class Chains : private AnalysisContext {
 public:
  Chains(const AnalysisContext& context, const Times& times) : AnalysisContext(context), times_(times) {}

  std::vector<NodeId> to(NodeId last) const {
    std::vector<NodeId> chain{last};
    const pan::Processor& on = problem.processors[thread_of(last).processor];
    if (!on.preemptive || source(last).period == never) return chain;
    while (chain.size() < most_in_chain && follows_at_once(chain.front())) {
      const NodeId cause = node(chain.front()).cause;
      if (!sends_at_once(cause)) break;
      chain.insert(chain.begin(), cause);
    }
    while (!goes_on(chain)) chain.erase(chain.begin());
    return chain;
  }

 private:
  Nanoseconds earliest(NodeId n) const { return times_.nodes[n].earliest; }
  bool is_bounded(ThreadId thread) const {
    const ThreadId t = thread;
    return times_.unbounded_reason[t].empty() && !times_.blocked[t];
  }

  /// Whether a node on its cause's processor is released by its cause's send itself, if its thread waits.
  bool follows_at_once(NodeId n) const {
    const Node& of = node(n);
    if (of.release != Node::Release::message || of.device.valid() || way(n).worst != 0) return false;
    if (thread_of(n).processor != thread_of(of.cause).processor) return false;
    const ThreadId thread = forest.thread_of(n);
    if (!is_bounded(thread)) return false;
    if (!behaviours.previous[n].empty()) return true;  // goes_on() looks there
    return job_start_of(n) == n && is_done_before_next(*this, times_.nodes, thread) &&
           first_idle(*this, times_.nodes, thread) <= earliest(n) && is_free_after_job(thread, earliest(n));
  }

  /// Whether none of a node's sends finds its slot full.
  bool sends_at_once(NodeId n) const {
    if (!is_bounded(forest.thread_of(n))) return false;
    const auto& steps = segment(n).steps;
    return std::all_of(steps.begin(), steps.end(), [&](const Segment::Passed& passed) {
      return held_until(*this, times_.nodes, n, passed.step) <= earliest(n);
    });
  }

  /// Whether no send of a thread's previous job keeps it after `from`, in the job that comes then.
  bool is_free_after_job(ThreadId thread, Nanoseconds from) const {
    const auto& nodes = behaviour_of(thread).nodes;
    return std::all_of(nodes.begin(), nodes.end(), [&](NodeId n) {
      const auto& steps = segment(n).steps;
      return std::all_of(steps.begin(), steps.end(), [&](const Segment::Passed& passed) {
        const Nanoseconds until = held_until(*this, times_.nodes, n, passed.step);
        return until < never && until <= plus(from, source(n).period);
      });
    });
  }

  /// Whether threads that wait within their jobs come to these waits within the chain.
  bool goes_on(const std::vector<NodeId>& chain) const {
    for (std::size_t i = 1; i < chain.size(); ++i) {
      for (NodeId before : behaviours.previous[chain[i]]) {
        if (std::find(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(i), before) ==
            chain.begin() + static_cast<std::ptrdiff_t>(i))
          return false;
      }
    }
    return true;
  }

  const Times& times_;
};

}  // namespace

std::vector<NodeId> joint_chain(const AnalysisContext& context, const Times& times, NodeId node) {
  return Chains(context, times).to(node);
}

}  // namespace pal::analyzer::compositional
