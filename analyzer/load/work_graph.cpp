#include "analyzer/load/work_graph.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

namespace pal::analyzer {
namespace {

/// What a timer measures: of a thread its action, its giving up or the limit of its wait, at a step.
struct Meaning {
  enum class Kind { other, action, gives_up, limit };
  int timer = -1;
  StepId step{};
  Kind kind = Kind::other;

  friend auto operator<=>(const Meaning&, const Meaning&) = default;
};

class Builder {
 public:
  Builder(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence, ProcessorId processor)
      : machine_(machine), graph_(graph), recurrence_(recurrence), processor_(processor) {}

  WorkGraph build() {
    for (int c : recurrence_.classes) node_.emplace(c, static_cast<int>(node_.size()));
    made_.nodes = static_cast<int>(node_.size());
    for (int e : recurrence_.edges) note_starts(graph_.edges()[static_cast<std::size_t>(e)]);
    std::set<std::tuple<int, int, int>> seen;
    for (int e : recurrence_.edges) {
      const Edge& edge = graph_.edges()[static_cast<std::size_t>(e)];
      if (seen.insert({edge.from, edge.to, edge.move}).second) add(edge);
    }
    std::set<std::vector<int>> together;
    for (int c : recurrence_.classes) note_together(c, together);
    keep_greatest(together);
    return std::move(made_);
  }

 private:
  const Place& place_of(int c) const {
    const ZoneClass& of = graph_.classes()[static_cast<std::size_t>(c)];
    return graph_.places()[static_cast<std::size_t>(of.state)];
  }
  const Move& move_of(const Edge& edge) const {
    return place_of(edge.from).moves[static_cast<std::size_t>(edge.move)];
  }

  Meaning meaning(const State& state, int timer) const {
    if (!machine_.is_of_thread(timer)) return {timer, StepId{}, Meaning::Kind::other};
    const ThreadState& thread = state.threads[machine_.thread_of(timer)];
    const Meaning::Kind kind = thread.status == Status::waiting         ? Meaning::Kind::limit
                               : thread.choice == ThreadState::gives_up ? Meaning::Kind::gives_up
                                                                        : Meaning::Kind::action;
    return {timer, thread.at(), kind};
  }

  bool ours(const Meaning& of) const {
    return (of.kind == Meaning::Kind::action || of.kind == Meaning::Kind::gives_up) &&
           machine_.problem().threads[machine_.thread_of(of.timer)].processor == processor_;
  }

  /// What surely passes from the start of a timer to its end; of the processor's own actions, what may.
  Nanoseconds passes(const Meaning& of, const Range& range) const {
    return ours(of) ? range.worst : range.best;
  }

  void note_starts(const Edge& edge) {
    const Move& move = move_of(edge);
    for (const Move::Kept& kept : move.timers) {
      if (kept.before >= 0) continue;
      const Meaning of = meaning(move.outcome.state, kept.timer);
      const Nanoseconds time = passes(of, kept.range);
      if (time == 0) continue;
      const auto [known, added] = share_.try_emplace(of, made_.shares);
      if (added) {
        ++made_.shares;
        longest_.push_back(0);
      }
      Nanoseconds& longest = longest_[static_cast<std::size_t>(known->second)];
      longest = std::max(longest, time);
    }
  }

  int share_of(const Meaning& of) const {
    const auto found = share_.find(of);
    return found == share_.end() ? -1 : found->second;
  }

  /// How much of what a timer was to count may still be to come when `edge` fires.
  Nanoseconds remaining(const Edge& edge, std::size_t timer, int share) const {
    const Nanoseconds longest = longest_[static_cast<std::size_t>(share)];
    const Place& from = place_of(edge.from);
    if (from.frozen[timer]) return longest;
    const Dbm& zone = graph_.classes()[static_cast<std::size_t>(edge.from)].zone;
    return std::min(longest, zone.at(timer + 1, move_of(edge).variable));
  }

  void add(const Edge& edge) {
    const Place& from = place_of(edge.from);
    const Move& move = move_of(edge);
    WorkEdge made{node_.at(edge.from), node_.at(edge.to), 0, {}};
    // A timer goes on if it measures the same before and after.
    std::vector<bool> goes_on(from.timers.size());
    for (const Move::Kept& kept : move.timers) {
      const Meaning now = meaning(move.outcome.state, kept.timer);
      if (kept.before >= 0) {
        const auto before = static_cast<std::size_t>(kept.before);
        goes_on[before] = now == meaning(from.state, kept.timer);
        if (goes_on[before]) continue;
      }
      const int share = share_of(now);
      if (share < 0) continue;
      const auto index = static_cast<std::size_t>(share);
      if (ours(now)) {
        made.work += kept.before < 0 ? kept.range.worst : longest_[index];
        made.passing.push_back({share, kept.before < 0 ? kept.range.worst : longest_[index]});
      } else if (kept.before < 0) {
        made.passing.push_back({share, kept.range.best});
      }
    }
    for (std::size_t k = 0; k < from.timers.size(); ++k) {
      if (goes_on[k] || from.timers[k] == move.timer) continue;
      const Meaning before = meaning(from.state, from.timers[k]);
      const int share = share_of(before);
      if (share >= 0 && !ours(before)) made.passing.push_back({share, -remaining(edge, k, share)});
    }
    made_.edges.push_back(std::move(made));
  }

  void note_together(int c, std::set<std::vector<int>>& together) const {
    const Place& place = place_of(c);
    const Dbm& zone = graph_.classes()[static_cast<std::size_t>(c)].zone;
    std::vector<int> shares;
    for (std::size_t k = 0; k < place.timers.size(); ++k) {
      if (place.frozen[k]) continue;
      if (zone.at(k + 1, 0) == 0) return;  // no time passes here
      const int share = share_of(meaning(place.state, place.timers[k]));
      if (share >= 0) shares.push_back(share);
    }
    std::sort(shares.begin(), shares.end());
    if (!shares.empty()) together.insert(std::move(shares));
  }

  void keep_greatest(const std::set<std::vector<int>>& together) {
    for (const std::vector<int>& each : together) {
      const bool within = std::any_of(together.begin(), together.end(), [&each](const auto& other) {
        return other.size() > each.size() &&
               std::includes(other.begin(), other.end(), each.begin(), each.end());
      });
      if (!within) made_.together.push_back(each);
    }
  }

  const Machine& machine_;
  const ZoneGraph& graph_;
  const Recurrence& recurrence_;
  ProcessorId processor_;
  std::unordered_map<int, int> node_;  // by class
  std::map<Meaning, int> share_;
  std::vector<Nanoseconds> longest_;  // by share: of all that passes() says of it
  WorkGraph made_;
};

}  // namespace

WorkGraph work_graph(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence,
                     ProcessorId processor) {
  return Builder(machine, graph, recurrence, processor).build();
}

}  // namespace pal::analyzer
