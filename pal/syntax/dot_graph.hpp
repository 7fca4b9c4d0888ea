// Graphviz' DOT as text: nodes, edges and attributes with their places. Read here and not by cgraph, which
// keeps no places and, being made for trusted files, no limits.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::syntax {

struct DotValue {
  std::string text;
  SourceSpan where;
};
using DotValues = std::map<std::string, DotValue>;

struct DotNode {
  std::string name;
  SourceSpan where;  // the first mention
  DotValues values;
};

struct DotEdge {
  std::size_t from = 0;  // indices into nodes
  std::size_t to = 0;
  SourceSpan where;  // from its first node to its last
  DotValues values;
};

/// A directed graph. Subgraphs are transparent; ports are dropped; defaults (`node [...]`) are filled in.
struct DotGraph {
  SourceSpan where;  // its first word
  DotValues values;
  std::vector<DotNode> nodes;
  std::vector<DotEdge> edges;
};

/// Reads one graph. What is no DOT is reported (PAL0114), once, and gives nothing. Never throws.
std::optional<DotGraph> parse_dot_graph(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
