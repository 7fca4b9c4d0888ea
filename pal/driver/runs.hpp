// Where the runs of `pal simulate` come from: chance, or the scripts of witnesses.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "analyzer/run_checker/witness_file.hpp"
#include "analyzer/runs/simulate.hpp"
#include "pal/driver/survey.hpp"

namespace pal::driver {

/// Runs that can be made one by one, and again.
struct Runs {
  std::vector<std::string> names;  // "seed 7", "the script of fresh-force"
  /// Nothing: run `number` cannot be made as it was asked for.
  std::function<std::optional<KnownRun>(std::size_t number)> make;
};

/// `count` runs, with the seeds from that of `options` on. `problem` must outlive them.
Runs runs_by_chance(const analyzer::Problem& problem, const analyzer::SimulationOptions& options,
                    std::size_t count);

/// A run for each witness, which all are of `problem`: made by the machine as the witness's script says,
/// without looking at the witness's events. Both must outlive them.
Runs scripted_runs(const analyzer::Problem& problem,
                   const std::vector<analyzer::rules::FiledWitness>& witnesses);

}  // namespace pal::driver
