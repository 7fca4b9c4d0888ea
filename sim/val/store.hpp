// VAL's memory: taught locations, numbers and programs, by name; and its form in a file.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/val/transformation.hpp"

namespace pal::sim::val {

struct Store {
  std::map<std::string, Pose> locations;
  std::map<std::string, double> reals;
  std::map<std::string, std::vector<std::string>> programs;  // one instruction a line
};

/// A line of a file that cannot be read. `line` from 1.
struct StoreProblem {
  int line = 0;
  std::string cause;
};

/// Reads sections as VAL writes them to a disk: `.LOCATIONS`, `.REALS`, `.PROGRAM name`, each to its `.END`.
/// Empty lines and what follows a `;` are passed over. What is read is added to `store`, up to the first
/// problem.
std::vector<StoreProblem> read_store(std::string_view text, Store& store);

/// What read_store reads: the same store within rounding of 1e-4 mm and 1e-5 degrees.
std::string write_store(const Store& store);

}  // namespace pal::sim::val
