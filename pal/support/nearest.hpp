// "Did you mean …?"
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pal {

/// The candidate that a slip of the fingers would turn into `name`: fewest single-letter insertions,
/// deletions, replacements and swaps of neighbours, at most a third of the name's length; letter case counts
/// half. The first of equals.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace pal
