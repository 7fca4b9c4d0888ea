// What changed between two texts, for people.
#pragma once

#include <string>
#include <string_view>

namespace pal {

/// The lines that differ, as a unified diff with three lines of context; the names stand in its head.
/// Empty if the texts are the same. Time and memory are in proportion to the number of lines times the number
/// that differ.
std::string line_difference(const std::string& old_name, std::string_view before, const std::string& new_name,
                            std::string_view after);

}  // namespace pal
