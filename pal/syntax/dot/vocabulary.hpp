// The kinds of node that a PAN has, and what each is told by: docs/reference/pan.md as a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/dot/graph.hpp"

namespace pal::syntax {

struct DotKind {
  std::string_view name;
  std::vector<std::string_view> needs;
  std::vector<std::string_view> may_have;
};

/// The kind of this name, or nullptr.
const DotKind* dot_kind(std::string_view name);

/// Has any node, edge or graph an attribute of this name?
bool is_dot_attribute(std::string_view name);

/// A warning (PAL0117) that there is no such attribute, with the nearest one.
void report_strange_attribute(const DotValue& name, Diagnostics& diagnostics);

/// Does the node have a known kind, and all attributes that the kind needs? If not, reports it (PAL0115). An
/// attribute that the kind does not have is a warning (PAL0117).
bool check_attributes(const DotNode& node, Diagnostics& diagnostics);

}  // namespace pal::syntax
