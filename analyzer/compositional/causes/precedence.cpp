#include "analyzer/compositional/causes/precedence.hpp"

#include <algorithm>
#include <cstdint>

#include "analyzer/compositional/causes/sequence.hpp"

namespace pal::analyzer::compositional {
namespace {

/// More pairs of segments in one module than this are not looked at.
constexpr std::size_t most_pairs = 40'000;

/// Of more nodes that come once only the causes are looked at.
constexpr std::size_t most_once = 2'000;

class Precedence {
 public:
  Precedence(const AnalysisContext& context, const std::function<bool()>& stop)
      : context_(context),
        stop_(stop),
        later_(context.forest.nodes.size()),
        never_overlapping_(context.forest.nodes.size()) {}

  Order run() {
    in_programs();
    by_causes();
    in_life();
    for (const SourceId s : context_.forest.sources.ids()) in_circle(s);
    sort(later_);
    sort(never_overlapping_);
    return {std::move(later_), std::move(never_overlapping_)};
  }

 private:
  using Nodes = std::set<NodeId>;

  bool is_over() const { return stop_ && stop_(); }

  void in_programs() {
    std::map<pan::ModuleId, std::vector<NodeId>> by_module;
    for (const NodeId n : later_.ids()) by_module[context_.thread_of(n).module].push_back(n);
    Sequence sequence(context_.problem);
    for (const auto& [module, nodes] : by_module) {
      if (is_over()) return;
      if (nodes.size() * nodes.size() > most_pairs) continue;
      for (NodeId node : nodes) {
        for (NodeId other : nodes) {
          if (node != other &&
              !sequence.may_follow(context_.segment(other).beginning, context_.segment(node).beginning))
            later_[node].push_back(other);
        }
      }
    }
  }

  /// What comes once and brings about something else that comes once, or is what its thread waited for
  /// before.
  void by_causes() {
    std::vector<NodeId> once;
    for (const NodeId n : later_.ids()) {
      if (context_.source(n).period == never) once.push_back(n);
    }
    place_.assign(later_.size(), -1);
    for (std::size_t i = 0; i < once.size(); ++i) place_[once[i]] = static_cast<int>(i);
    const std::size_t words = once.size() <= most_once ? (once.size() + 63) / 64 : 0;
    over_.assign(once.size(), Bits(words));
    // Each round adds what follows from the one before. To end early is right, too.
    for (bool more = words > 0; more && !is_over();) {
      more = false;
      for (const NodeId n : once) more = add_over(n) || more;
    }
    for (const NodeId n : once) {
      if (is_over()) return;
      for (NodeId at = n; context_.node(at).cause.valid(); at = context_.node(at).cause) {
        if (ends_with_cause(context_.problem, context_.forest, at)) before(context_.node(at).cause, n);
      }
      for (std::size_t i = 0; words > 0 && i < once.size(); ++i) {
        if (over_of(n).has(i)) before(once[i], n);
      }
    }
  }

  /// `node` is over before `later` is released.
  void before(NodeId node, NodeId later) {
    later_[node].push_back(later);
    never_overlapping_[later].push_back(node);
  }

  /// Of nodes that come once, by place_.
  struct Bits {
    explicit Bits(std::size_t count) : words(count) {}
    bool has(std::size_t at) const { return (words[at / 64] >> at % 64 & 1U) != 0; }
    void add(std::size_t at) { words[at / 64] |= std::uint64_t{1} << at % 64; }
    void join(const Bits& other) {
      for (std::size_t w = 0; w < words.size(); ++w) words[w] |= other.words[w];
    }
    void meet(const Bits& other) {
      for (std::size_t w = 0; w < words.size(); ++w) words[w] &= other.words[w];
    }
    std::vector<std::uint64_t> words;
  };

  Bits& over_of(NodeId node) { return over_[static_cast<std::size_t>(place_[node])]; }

  /// A node that is over, with what was over before it.
  Bits up_to_end_of(NodeId node) {
    const int place = place_[node];
    if (place < 0) return Bits(over_.front().words.size());
    Bits all = over_of(node);
    all.add(static_cast<std::size_t>(place));
    return all;
  }

  /// What is over before a node that comes once is released. That is what was over before its cause was, and
  /// the cause itself if it has ended. It is also what was over when its thread came to the wait, in
  /// whichever way. False: nothing new.
  bool add_over(NodeId n) {
    Bits over = over_of(n);
    const NodeId cause = context_.node(n).cause;
    if (cause.valid() && place_[cause] >= 0) {
      const bool ended = ends_with_cause(context_.problem, context_.forest, n);
      over.join(ended ? up_to_end_of(cause) : over_of(cause));
    }
    const std::vector<NodeId>& previous = context_.behaviours.previous[n];
    if (!previous.empty()) {
      Bits common = up_to_end_of(previous.front());
      for (const NodeId each : previous) common.meet(up_to_end_of(each));
      over.join(common);
    }
    if (over.words == over_of(n).words) return false;
    over_of(n) = std::move(over);
    return true;
  }

  /// What starts again, or loops, after something that happens once.
  void in_life() {
    const auto& sources = context_.forest.sources;
    Table<SourceId, std::vector<NodeId>> nodes_of(sources.size());
    for (const NodeId n : later_.ids()) nodes_of[context_.node(n).source].push_back(n);
    for (const SourceId s : sources.ids()) {
      if (is_over()) return;
      for (const NodeId before : before_source(s, {})) {
        auto& later = later_[before];
        later.insert(later.end(), nodes_of[s].begin(), nodes_of[s].end());
        for (const NodeId n : nodes_of[s]) never_overlapping_[n].push_back(before);
      }
    }
  }

  /// The nodes of a cycle in which one message circulates: triggered once from outside, and then in each turn
  /// by one of them.
  void in_circle(SourceId source) {
    const Source& of = context_.forest.sources[source];
    if (of.kind != Source::Kind::loop || of.feeds.size() != 2) return;
    const auto own = std::find_if(of.feeds.begin(), of.feeds.end(), [&](const Source::Feed& feed) {
      return feed.node.valid() && context_.node(feed.node).source == source;
    });
    const auto outer = std::find_if(of.feeds.begin(), of.feeds.end(), [&](const Source::Feed& feed) {
      return feed.node.valid() && context_.source(feed.node).kind == Source::Kind::start;
    });
    if (own == of.feeds.end() || outer == of.feeds.end()) return;
    std::vector<NodeId> circle;
    bool ended = own->wait.valid() || end_segment(context_.problem, own->sends);
    for (NodeId at = own->node; at.valid(); at = context_.node(at).cause) {
      if (!ended) return;
      circle.push_back(at);
      ended = ends_with_cause(context_.problem, context_.forest, at);
    }
    for (NodeId node : circle) {
      for (NodeId other : circle) {
        if (other != node) never_overlapping_[node].push_back(other);
      }
    }
  }

  static void sort(Table<NodeId, std::vector<NodeId>>& lists) {
    for (std::vector<NodeId>& each : lists) {
      std::sort(each.begin(), each.end());
      each.erase(std::unique(each.begin(), each.end()), each.end());
    }
  }

  /// The nodes that come once and are done before a source occurs for the first time. `asked`: sources on the
  /// way to this one, which cannot be what first brings it about.
  Nodes before_source(SourceId source, std::set<SourceId> asked) const {
    const Source& of = context_.forest.sources[source];
    asked.insert(source);
    std::optional<Nodes> all;
    const auto also = [&all](Nodes nodes) {
      if (!all) {
        all = std::move(nodes);
        return;
      }
      std::erase_if(*all, [&nodes](NodeId node) { return !nodes.contains(node); });
    };
    if (of.kind == Source::Kind::loop) {
      for (const Source::Feed& feed : of.feeds) {
        if (!feed.node.valid()) return {};
        const SourceId by = context_.node(feed.node).source;
        if (asked.contains(by)) continue;
        const bool ends = feed.wait.valid() || end_segment(context_.problem, feed.sends);
        also(up_to(feed.node, ends, asked));
      }
    } else if (of.kind == Source::Kind::joined) {
      for (const NodeId n : later_.ids()) {
        if (asked.contains(context_.node(n).source)) continue;
        const auto& forks = context_.segment(n).forks;
        const bool starts = std::any_of(forks.begin(), forks.end(),
                                        [&of](const Segment::Arrival& at) { return at.step == of.fork; });
        if (starts) also(up_to(n, true, asked));
      }
    }
    return all.value_or(Nodes{});
  }

  /// A node, if it has `ended`, and its causes, if they come once; else what is done before their source
  /// occurs.
  Nodes up_to(NodeId node, bool ended, const std::set<SourceId>& asked) const {
    const Source& source = context_.source(node);
    if (source.kind != Source::Kind::start && source.kind != Source::Kind::joined)
      return before_source(context_.node(node).source, asked);
    Nodes all =
        source.kind == Source::Kind::joined ? before_source(context_.node(node).source, asked) : Nodes{};
    for (NodeId at = node; at.valid(); at = context_.node(at).cause) {
      if (ended) all.insert(at);
      ended = ends_with_cause(context_.problem, context_.forest, at);
    }
    return all;
  }

  const AnalysisContext& context_;
  const std::function<bool()>& stop_;
  Table<NodeId, std::vector<NodeId>> later_;
  Table<NodeId, std::vector<NodeId>> never_overlapping_;
  Table<NodeId, int> place_;  // its number among those that come once; -1: it may come again
  std::vector<Bits> over_;    // by that number: what is over before it is released
};

}  // namespace

Order order_of(const AnalysisContext& context, const std::function<bool()>& stop) {
  return Precedence(context, stop).run();
}

}  // namespace pal::analyzer::compositional
