// A DOT text as nodes, edges and the attributes that PAL gives them, each with its place.
//
// Graphviz' own cgraph, which writes the SVG, is not used for reading. It keeps no places, so no error could
// name a line. It reports errors to one function for the whole program. And it is made for trusted texts
// (docs/reference/pan.md).
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::syntax {

struct DotValue {
  std::string text;
  SourceSpan where;
};

/// Attributes by name; only those that begin with pal_.
class DotValues {
 public:
  /// Nothing if the attribute is not given.
  const DotValue* find(std::string_view name) const;
  /// Is the attribute given as `true`?
  bool is_true(std::string_view name) const;
  void set(std::string_view name, DotValue value);

  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  bool empty() const { return values_.empty(); }

 private:
  // Shared, for a default may be long and stand for many nodes.
  std::map<std::string, std::shared_ptr<const DotValue>, std::less<>> values_;
};

struct DotNode {
  std::string name;
  SourceSpan where;  // where its attributes are given; else the first mention
  DotValues values;
};

struct DotEdge {
  std::size_t from = 0;  // indices into nodes
  std::size_t to = 0;
  SourceSpan where;  // from its first node to its last
  std::shared_ptr<const DotValues> values;
};

/// A directed graph. Subgraphs are transparent; ports are dropped; defaults (`node [...]`) are filled in.
struct DotGraph {
  SourceSpan where;  // its first word
  DotValues values;
  std::vector<DotNode> nodes;  // in the order of their first mention
  std::vector<DotEdge> edges;
};

/// Bounds of what is read: far beyond what can be drawn.
constexpr std::size_t most_dot_nodes = 100'000;
constexpr std::size_t most_dot_edges = 200'000;

/// Reads one graph. Text that is not DOT is reported (PAL0114), once, and gives nothing. An unknown attribute
/// of PAL is reported (PAL0117) and left out. Never throws.
std::optional<DotGraph> read_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
