#include "analyzer/compositional/times/inter_arrival.hpp"

#include <algorithm>

#include "analyzer/compositional/times/slots.hpp"

namespace pal::analyzer::compositional {
namespace {

struct InterArrival {
  Due gap{never};
  Due first{never};
};

void raise(Due& at, const Due& to) {
  if (to.at > at.at) at = to;
}

/// The jobs of a free-running thread: all that leads from one to the next.
class Loop {
 public:
  Loop(const AnalysisContext& context, const Times& times, SourceId source)
      : context_(context), times_(times), index_(source), of_(context.forest.sources[source]) {}

  InterArrival run() const {
    if (!times_.unbounded_reason[of_.thread].empty()) return {};
    InterArrival found{Due{0}, Due{0}};
    bool comes = false;
    Nanoseconds between = 0;
    for (const Source::Feed& feed : of_.feeds) {
      if (!feed.node.valid()) return {};
      const Node& from = context_.node(feed.node);
      const Source::Kind by = context_.forest.sources[from.source].kind;
      if (from.source == index_) {
        raise(found.gap, latest(feed));
        comes = true;
      } else if (by == Source::Kind::start) {
        raise(found.first, latest(feed));
      } else if (by == Source::Kind::joined) {
        found.first = Due{never};
      } else {
        return {};
      }
      if (from.source != index_ && feed.wait.valid()) between = plus(between, put_off(feed));
    }
    if (!comes) return {};
    back_at_wait(found);
    if (between > 0) found.gap = Due{plus(found.gap.at, between)};
    return found;
  }

 private:
  /// How much later the wait gives up if what comes once is taken there before: a job goes by, and the
  /// limit starts again.
  Nanoseconds put_off(const Source::Feed& feed) const {
    if (!context_.in_job(feed.node)) return 0;
    const Nanoseconds back = latest(feed).at;
    const NodeId job_start = context_.job_start_of(feed.node);
    return back >= never ? never : back - times_.nodes[job_start].earliest;
  }

  /// When what leads to the next job is there.
  Due latest(const Source::Feed& feed) const {
    if (feed.wait.valid()) {
      const Nanoseconds limit = context_.step_at(feed.wait).within.value_or(0);
      const Nanoseconds arrival = latest_arrival(context_, times_.nodes, feed.node, feed.wait);
      return {plus(arrival, limit), Due::By::arrival, feed.node, feed.wait, limit};
    }
    const ChannelId channel = context_.step_at(feed.sends.front()).channels.front();
    Due due{-1, Due::By::message, feed.node};
    for (StepId send : feed.sends)
      raise(due, {latest_effect(context_.forest, times_.nodes, feed.node, send), Due::By::message, feed.node,
                  send});
    due.after =
        feed.device.valid()
            ? plus(context_.device_time(feed.device).worst, context_.answer_queue(feed.device, channel))
            : latency(context_.problem, channel, context_.forest.thread_of(feed.node), of_.thread).worst;
    due.at = plus(due.at, due.after);
    return due;
  }

  /// The thread itself must be back, too.
  void back_at_wait(InterArrival& found) const {
    const StepId wait = context_.forest.segments[of_.segment].beginning.step;
    for (NodeId n : context_.behaviour_of(of_.thread).nodes) {
      const Segment& segment = context_.segment(n);
      for (std::size_t w = 0; w < segment.waits.size(); ++w) {
        if (segment.waits[w].step != wait) continue;
        const Due arrival{times_.nodes[n].arrivals[w], Due::By::arrival, n, wait};
        if (context_.node(n).source == index_) raise(found.gap, arrival);
        if (context_.source(n).kind == Source::Kind::start) raise(found.first, arrival);
        if (context_.source(n).kind == Source::Kind::joined) found.first = Due{never};
      }
    }
  }

  const AnalysisContext& context_;
  const Times& times_;
  SourceId index_;
  const Source& of_;
};

}  // namespace

Nanoseconds first_idle(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
                       ThreadId thread) {
  const ThreadBehaviour& of = context.behaviour_of(thread);
  Nanoseconds latest = 0;
  for (NodeId n : of.nodes) {
    if (context.in_job(n)) continue;
    // What an event triggers has no instant that jobs of other sources could be compared with. The same holds
    // behind blocks that end in an unknown job.
    const bool known = context.source(n).kind == Source::Kind::start;
    latest = std::max(latest, known ? latest_arrival(context, nodes, n, of.idle_wait) : never);
  }
  // A thread that waits for it waits until the skill has ended instead.
  for (NodeId n : context.endings_before_idle(thread)) latest = std::max(latest, nodes[n].finish);
  return latest;
}

Nanoseconds latest_arrival(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                           StepId step) {
  const Segment& of = context.segment(node);
  for (std::size_t w = 0; w < of.waits.size(); ++w) {
    if (of.waits[w].step == step) return nodes[node].arrivals[w];
  }
  return nodes[node].finish;
}

void find_inter_arrivals(const AnalysisContext& context, Times& times) {
  for (const SourceId s : context.forest.sources.ids()) {
    const Source& of = context.forest.sources[s];
    const bool event = of.kind == Source::Kind::event;
    const bool taken =
        event && of.roots.size() == 1 && take_in_time(context, times.nodes, of.roots.front(), 0);
    times.no_overrun.push_back(taken);
    InterArrival found;
    if (taken && of.regular) {
      const Nanoseconds ready = first_idle(context, times.nodes, context.forest.thread_of(of.roots.front()));
      found = {Due{of.period, Due::By::source, NodeId{}, StepId{}, of.period},
               Due{plus(ready, of.period), Due::By::idle, NodeId{}, StepId{}, of.period}};
    } else if (of.kind == Source::Kind::loop) {
      found = Loop(context, times, s).run();
    }
    times.longest_gap.push_back(found.gap);
    times.first.push_back(found.first);
  }
}

}  // namespace pal::analyzer::compositional
