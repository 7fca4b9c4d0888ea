#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

using TermKind = Term::Kind;

Sum latest(const View& view, int node, StepId step) {
  return {latest_effect(view.forest, view.times.nodes, node, step), {TermKind::latest, node, step, -1, ""}};
}

Sum since_event(const View& view, int node, StepId step) {
  return {latest_effect(view.forest, view.times.since_event, node, step),
          {TermKind::since_event, node, step, -1, ""}};
}

Sum finish_since_event(const View& view, int node) {
  return {view.times.since_event[static_cast<std::size_t>(node)].finish,
          {TermKind::since_event, node, {}, -1, ""}};
}

Sum since_cause(const View& view, int cause, StepEffect effect) {
  const Nanoseconds at = latest_effect(view.forest, view.times.nodes, effect.node, effect.step);
  const Nanoseconds released = view.times.nodes[static_cast<std::size_t>(cause)].latest;
  if (at >= never || released >= never) return Sum::unbounded();
  return {at - released, {TermKind::since_cause, effect.node, effect.step, -1, "", cause}};
}

Sum earliest(const View& view, int node, StepId step) {
  return {earliest_effect(view.forest, view.times, node, step), {TermKind::earliest, node, step, -1, ""}};
}

Sum finish(const View& view, int node) {
  return {view.times.nodes[static_cast<std::size_t>(node)].finish, {TermKind::latest, node, {}, -1, ""}};
}

Sum release(const View& view, int node) {
  return {view.times.nodes[static_cast<std::size_t>(node)].latest, {TermKind::release, node, {}, -1, ""}};
}

Sum gap(const View& view, int source) {
  return {view.times.longest_gap[static_cast<std::size_t>(source)].at, {TermKind::gap, -1, {}, source, ""}};
}

Sum first(const View& view, int source) {
  return {view.times.first[static_cast<std::size_t>(source)].at, {TermKind::first, -1, {}, source, ""}};
}

}  // namespace pal::analyzer::compositional
