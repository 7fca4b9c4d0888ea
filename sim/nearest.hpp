// "Did you mean …?"
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pal::sim {

/// The name with the fewest changed, added or missing letters, if they are at most a third of the wanted name's
/// (and always two are allowed in names of four and more). The first of several.
std::optional<std::string> nearest_name(const std::string& wanted, const std::vector<std::string>& names);

}  // namespace pal::sim
