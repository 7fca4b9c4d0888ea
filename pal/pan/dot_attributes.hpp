// Parts of a DOT file: quoting, and the attributes that hold a node's content.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::pan {

/// Name and value, in the order in which they are written.
using DotAttributes = std::vector<std::pair<std::string, std::string>>;

/// In double quotes, with what DOT would read as something else escaped.
std::string dot_quoted(std::string_view text);

/// `[a="x", b="y"]`. A value that begins with '<' and ends with '>' is HTML-like and is not quoted.
std::string dot_list(const DotAttributes& attributes);

/// What the graph of a module says of it besides its nodes. Activities are told by the nodes that perform
/// them, unless one has no node or they are declared in another order.
DotAttributes content_attributes(const Network& network, ModuleId module);

/// The whole content of a node: pal_kind and what else that kind has (docs/reference/pan.md).
DotAttributes content_attributes(const Network& network, const Node& node);

}  // namespace pal::pan
