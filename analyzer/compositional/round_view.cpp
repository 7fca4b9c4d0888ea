#include "analyzer/compositional/round_view.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {

bool in_round(const View& view, int node) {
  const auto thread = static_cast<std::size_t>(view.forest.thread_of(node));
  const auto& rounds = view.conduct.threads[thread].rounds;
  return std::find(rounds.begin(), rounds.end(), view.conduct.round[static_cast<std::size_t>(node)]) !=
         rounds.end();
}

int source_of_rounds(const View& view, int thread) {
  int source = -1;
  for (int n : view.conduct.threads[static_cast<std::size_t>(thread)].rounds) {
    const int of = view.forest.nodes[static_cast<std::size_t>(n)].source;
    if (source >= 0 && source != of) return -1;
    source = of;
  }
  return source;
}

bool regular(const View& view, int thread) {
  const ThreadConduct& of = view.conduct.threads[static_cast<std::size_t>(thread)];
  if (of.rounds.empty() || source_of_rounds(view, thread) < 0) return false;
  const Node& first = view.forest.nodes[static_cast<std::size_t>(of.rounds.front())];
  const Source& source = view.forest.sources[static_cast<std::size_t>(first.source)];
  if (of.rounds.size() == 1 && first.cause < 0 && source.kind == Source::Kind::loop) return true;
  if (source.kind != Source::Kind::event) return false;
  Requirement comes;
  comes.measure = Requirement::Measure::response;
  comes.device = source.device;
  comes.at.assign(view.problem.steps.size(), false);
  comes.at[static_cast<std::size_t>(of.home)] = true;
  return response_bound(view, comes).value < never;
}

std::vector<int> nodes_with(const View& view, int step) {
  std::vector<int> found;
  const int owner = view.forest.segments.owner(step);
  for (int n : view.conduct.threads[static_cast<std::size_t>(owner)].nodes) {
    for (const Segment::Passed& passed :
         view.forest.segment_of(view.forest.nodes[static_cast<std::size_t>(n)]).steps) {
      if (passed.step == step) found.push_back(n);
    }
  }
  return found;
}

std::set<int> owners(const View& view, const std::vector<bool>& at) {
  std::set<int> found;
  for (std::size_t s = 0; s < at.size(); ++s) {
    const int owner = view.forest.segments.owner(static_cast<int>(s));
    if (at[s] && owner >= 0) found.insert(owner);
  }
  return found;
}

}  // namespace pal::analyzer::compositional
