// What an event, or a message, brings about: where its response is.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

/// Follows what begins with a node from thread to thread, as far as every run must carry it: until it comes
/// to one of the statements `at`, or the skill has ended.
class EventPropagation {
 public:
  /// What the values count from.
  enum class Since { event, nominal };

  EventPropagation(const View& view, const std::vector<bool>& at, Since since)
      : view_(view), problem_(view.problem), at_(at), since_(since) {}

  /// When the first statement has had its effect at the latest, if a message begins this node.
  Sum node_value(int n);
  /// The same of the message that `n` sends by `send` to the one thread that takes it.
  Sum sent_value(int n, int send);
  /// Whether the thread of the node goes on in every run, as long as the skill lasts.
  bool certain(int n);
  /// Why a value is not bounded; empty if there is nothing to say.
  const std::string& why() const { return why_; }

 private:
  /// No way leads from here to an answer, nor to anything else.
  static Sum no_way() { return Sum::number(-1); }

  const Node& node(int n) const { return view_.forest.nodes[static_cast<std::size_t>(n)]; }
  const Segment& segment(int n) const { return view_.forest.segment_of(node(n)); }
  const Step& step_at(int step) const { return problem_.steps[static_cast<std::size_t>(step)]; }

  Sum reached(int n, int step) const {
    return since_ == Since::event ? since_event(view_, n, step) : latest(view_, n, step);
  }
  Sum finished(int n) const {
    return since_ == Since::event ? finish_since_event(view_, n) : finish(view_, n);
  }
  std::string unbounded_reason_of(int n) const;
  /// Whether what is sent is put, and not withdrawn before it is taken. A message that is not has no
  /// response; one that should carry an event leaves it without.
  bool is_put(int send);
  Sum beginning_value(int n);
  Sum step_value(int n, int at);
  /// The same, if it is known of the steps that follow.
  Sum value_of_step(int n, int at);
  /// Each block carries the event, as does its parent when they are over.
  Sum fork_value(int n, int fork);
  Sum wait_value(int n, int wait);

  const View& view_;
  const Problem& problem_;
  const std::vector<bool>& at_;
  Since since_;
  std::map<int, Sum> nodes_;
  std::map<std::pair<int, int>, Sum> steps_;
  std::string why_;
};

}  // namespace pal::analyzer::compositional
