// A module's body as Graphviz DOT, drawn as in the thesis, figure 3.4. docs/reference/pan.md lists the
// attributes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::pan {

struct DotOptions {
  enum class Direction { top_down, left_to_right };
  /// Statements in full read best from the top down; letters from left to right, as in the thesis.
  Direction direction = Direction::top_down;
  /// Statements as capital letters and conditions as c1, c2, …, with a key to both.
  bool letters = false;
  /// The condition of a CASE's arm, or of an UNTIL (arm 0), as its author wrote it. Where there is no
  /// function or no text, it is drawn as guard_text() spells it. Letters do not ask for it.
  std::function<std::string(NodeId node, std::size_t arm)> written{};
};

/// The graph of a module that has a body. Every node and edge carries its whole content in attributes that
/// begin with pal_, so that the module can be read back. The same network gives the same bytes.
std::string to_dot(const Network& network, ModuleId module, const DotOptions& options = {});

/// Lays a DOT graph out and draws it as SVG, by Graphviz. Throws std::runtime_error with Graphviz' message if
/// the text is not DOT or cannot be laid out.
std::string svg(const std::string& dot);

/// The middle of a node on the paper, in points; y grows downwards.
struct DotPlace {
  std::string node;
  double x = 0, y = 0;
};
/// Lays a DOT graph out: where its nodes are. Throws as svg().
std::vector<DotPlace> lay_out(const std::string& dot);

}  // namespace pal::pan
