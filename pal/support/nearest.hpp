// "Did you mean …?"
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pal {

/// The candidate of which `name` is most likely a misspelling. It has the fewest single-letter insertions,
/// deletions, replacements and swaps of neighbours, and at most a third of the name's length. A difference in
/// letter case counts half. Of equals, the first.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace pal
