// The edges of a PAN as ways from node to node.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/dot/graph.hpp"

namespace pal::syntax {

/// The ways out of each node. If a way that is asked for is missing, this is reported (PAL0116, PAL0115);
/// then it throws Reported.
class DotWays {
 public:
  DotWays(const DotGraph& graph, Diagnostics& diagnostics);

  bool none(std::size_t from) const { return out_[from].empty(); }
  /// The node that follows one that does not split.
  std::size_t only(std::size_t from) const;
  /// The nodes that the branches of `from` begin with, by pal_branch, or in the order of the text.
  std::vector<std::size_t> branches(std::size_t from) const;
  /// What stands behind the loop from `repeat` to `until`, which an edge must close. Of a loop that goes on
  /// for ever: what an edge with pal_stops or pal_never_taken leads to, if there is one.
  std::optional<std::size_t> behind_loop(std::size_t repeat, std::size_t until, bool forever) const;

 private:
  using Edges = std::vector<const DotEdge*>;

  std::size_t single(std::size_t from, const Edges& edges) const;
  bool closes(std::size_t repeat, std::size_t until) const;

  const DotGraph& graph_;
  Diagnostics& diagnostics_;
  std::vector<Edges> out_;
  std::vector<Edges> back_;  // drawn against the flow, from repeat to until
};

}  // namespace pal::syntax
