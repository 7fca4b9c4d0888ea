// What changed between two texts, for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pal {

/// The lines that differ, as a unified diff with three lines of context; the names stand in its head.
/// Empty if the texts are the same. Time and memory are in proportion to the number of lines times the number
/// that differ.
std::string line_difference(const std::string& old_name, std::string_view before, const std::string& new_name,
                            std::string_view after);

/// Whole lines of a text, by their bytes, and the lines that stand in their place in another.
struct LineChange {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

/// The few changes that make the one text the other. Time and memory as above.
std::vector<LineChange> line_changes(std::string_view before, std::string_view after);

}  // namespace pal
