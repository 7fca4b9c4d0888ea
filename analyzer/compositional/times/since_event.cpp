#include "analyzer/compositional/times/since_event.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "analyzer/compositional/times/joint_chain.hpp"
#include "analyzer/compositional/times/release.hpp"
#include "analyzer/compositional/times/slots.hpp"

namespace pal::analyzer::compositional {
namespace {

constexpr int most_event_rounds = 20;

/// Begins with the times from the nominal instants and lowers them. Each iteration follows the ways from
/// bounds to bounds, so the search may stop after any iteration.
class SinceEvents : private AnalysisContext {
 public:
  SinceEvents(const AnalysisContext& context, const Times& times, const Interference& interference)
      : AnalysisContext(context),
        times_(times),
        interference_(interference),
        made_(times.nodes),
        releases_(*this, made_, times.nodes, interference),
        shared_(context.forest.sources.size()) {
    for (const NodeId n : made_.ids()) {
      const bool event = source(n).kind == Source::Kind::event;
      chains_.push_back(event && made_[n].latest < never ? joint_chain(*this, times, n)
                                                         : std::vector<NodeId>{});
      if (chains_.back().size() > 1) shared_[node(n).source] = true;
    }
  }

  Table<NodeId, NodeTimes> run() {
    for (int iteration = 0; iteration < most_event_rounds; ++iteration) {
      bool changed = false;
      for (const NodeId n : made_.ids()) {
        // Without jitter, and without segments that share a window, the ways are no shorter than the times
        // from the nominal instant.
        const bool late =
            source(n).kind == Source::Kind::event && (source(n).jitter > 0 || shared_[node(n).source]);
        if (late && made_[n].latest < never) changed = lower(n) || changed;
      }
      if (!changed) break;
    }
    return std::move(made_);
  }

 private:
  bool lower(NodeId n) {
    NodeTimes& mine = made_[n];
    const NodeTimes before = mine;
    const Segment& of = segment(n);
    mine.latest = std::min(mine.latest, releases_.latest(n, times_.unbounded_reason, times_.blocked).at);
    const auto done = [&](Nanoseconds part) {
      return std::min(plus(mine.latest, from_release(n, part)), from_chain(n, part));
    };
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      if (mine.effects[s] == NodeTimes::unknown) continue;
      mine.worked[s] = std::min(mine.worked[s], done(of.steps[s].worst));
      const Nanoseconds held = held_until(*this, times_.nodes, n, of.steps[s].step);
      mine.effects[s] = std::min(mine.effects[s], std::max(mine.worked[s], held));
    }
    for (std::size_t w = 0; w < of.waits.size(); ++w) {
      const Nanoseconds sent = sent_before(*this, mine, n, of.waits[w].step);
      mine.arrivals[w] = std::min(mine.arrivals[w], std::max(done(of.waits[w].worst), sent));
    }
    mine.finish = std::min(mine.finish, done(of.worst));
    return mine.latest != before.latest || mine.finish != before.finish || mine.effects != before.effects ||
           mine.worked != before.worked || mine.arrivals != before.arrivals;
  }

  /// Latest end of the first `part` of a node's work after its release.
  Nanoseconds from_release(NodeId n, Nanoseconds part) {
    if (segment(n).steps.empty()) return 0;
    const auto [place, fresh] = known_.emplace(std::pair{n, part}, 0);
    if (fresh) place->second = interference_.finish(n, part, interference_.blocking(n), Since::release);
    return place->second;
  }

  /// The same through the segments that share a window with the node.
  Nanoseconds from_chain(NodeId n, Nanoseconds part) {
    Nanoseconds soonest = never;
    std::vector<NodeId> chain = chains_[n];
    for (; chain.size() > 1; chain.erase(chain.begin())) {
      const auto [place, fresh] = joint_.emplace(std::tuple{n, chain.size(), part}, 0);
      if (fresh) place->second = interference_.joint_finish(chain, part);
      const Nanoseconds released = made_[chain.front()].latest;
      soonest = std::min(soonest, plus(released, place->second));
    }
    return soonest;
  }

  const Times& times_;
  const Interference& interference_;
  Table<NodeId, NodeTimes> made_;
  Releases releases_;
  Table<NodeId, std::vector<NodeId>> chains_;                    // by node: joint_chain()
  Table<SourceId, bool> shared_;                                 // by source: it has such chains
  std::map<std::pair<NodeId, Nanoseconds>, Nanoseconds> known_;  // by node and part
  std::map<std::tuple<NodeId, std::size_t, Nanoseconds>, Nanoseconds>
      joint_;  // by node, length of chain, part
};

}  // namespace

Table<NodeId, NodeTimes> since_events(const AnalysisContext& context, const Times& times,
                                      const Interference& interference) {
  return SinceEvents(context, times, interference).run();
}

}  // namespace pal::analyzer::compositional
