#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

using TermKind = Term::Kind;

Sum latest(const View& view, NodeId node, StepId step) {
  return {latest_effect(view.forest, view.times.nodes, node, step), {TermKind::latest, node, step, {}, ""}};
}

Sum since_event(const View& view, NodeId node, StepId step) {
  return {latest_effect(view.forest, view.times.since_event, node, step),
          {TermKind::since_event, node, step, {}, ""}};
}

Sum finish_since_event(const View& view, NodeId node) {
  return {view.times.since_event[node].finish, {TermKind::since_event, node, {}, {}, ""}};
}

Sum since_cause(const View& view, NodeId cause, StepEffect effect) {
  const Nanoseconds at = latest_effect(view.forest, view.times.nodes, effect.node, effect.step);
  const Nanoseconds released = view.times.nodes[cause].latest;
  if (at >= never || released >= never) return Sum::unbounded();
  return {at - released, {TermKind::since_cause, effect.node, effect.step, {}, "", cause}};
}

Sum earliest(const View& view, NodeId node, StepId step) {
  return {earliest_effect(view.forest, view.times, node, step), {TermKind::earliest, node, step, {}, ""}};
}

Sum finish(const View& view, NodeId node) {
  return {view.times.nodes[node].finish, {TermKind::latest, node, {}, {}, ""}};
}

Sum release(const View& view, NodeId node) {
  return {view.times.nodes[node].latest, {TermKind::release, node, {}, {}, ""}};
}

Sum gap(const View& view, SourceId source) {
  return {view.times.longest_gap[source].at, {TermKind::gap, {}, {}, source, ""}};
}

Sum first(const View& view, SourceId source) {
  return {view.times.first[source].at, {TermKind::first, {}, {}, source, ""}};
}

}  // namespace pal::analyzer::compositional
