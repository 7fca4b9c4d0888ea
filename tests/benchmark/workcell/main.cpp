// Prints the workcell's figures beside what is required of them: bench_workcell [ROWS …].
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iostream>

#include "tests/benchmark/workcell/row.hpp"

using namespace pal::bench;

namespace {

struct Measurement {
  const char* name;
  std::vector<Row> (*rows)();
};

// Memory first: later ones leave theirs behind.
constexpr Measurement measurements[] = {
    {"memory", memory_rows}, {"speed", speed_rows}, {"scan", scan_rows},   {"motion", motion_rows},
    {"alter", alter_rows},   {"grasp", grasp_rows}, {"range", range_rows}, {"picture", picture_rows}};

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> chosen(arguments + 1, arguments + count);
  for (const std::string& name : chosen)
    if (std::none_of(std::begin(measurements), std::end(measurements),
                     [&](const auto& m) { return m.name == name; })) {
      std::cerr << "bench_workcell: error: there are no rows '" << name << "'; there are";
      for (const Measurement& measurement : measurements) std::cerr << ' ' << measurement.name;
      std::cerr << '\n';
      return 2;
    }
  bool met = true;
  fmt::print("{:<58} {:>18} {:>16}\n", "", "measured", "required");
  for (const Measurement& measurement : measurements) {
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), measurement.name) == chosen.end())
      continue;
    try {
      for (const Row& row : measurement.rows()) {
        fmt::print("{:<58} {:>18} {:>16}{}\n", row.what, row.measured, row.required,
                   row.met ? "" : "  MISSED");
        met = met && row.met;
      }
    } catch (const std::exception& problem) {
      fmt::print("{}: not measured: {}\n", measurement.name, problem.what());
      met = false;
    }
  }
  return met ? 0 : 1;
}
