// The sources of runs for `pal simulate`: random ones, or the scripts of witnesses.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "analyzer/run_checker/witness_file.hpp"
#include "analyzer/runs/simulate.hpp"
#include "programs/pal/session/survey.hpp"

namespace pal::program {

/// Runs that can be made one by one, and again.
struct Runs {
  std::vector<std::string> names;  // "seed 7", "the script of fresh-force"
  /// Nothing: run `number` cannot be made as asked.
  std::function<std::optional<KnownRun>(std::size_t number)> make;
};

/// `count` random runs, with consecutive seeds from that of `options`. `problem` must outlive them.
Runs runs_by_chance(const analyzer::Problem& problem, const analyzer::SimulationOptions& options,
                    std::size_t count);

/// A run for each witness, made by the machine from the witness's script alone; the witness's events are not
/// looked at. All witnesses are of `problem`. Both must outlive the runs.
Runs scripted_runs(const analyzer::Problem& problem,
                   const std::vector<analyzer::run_checker::FiledWitness>& witnesses);

}  // namespace pal::program
