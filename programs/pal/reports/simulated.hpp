// What `pal simulate` found of one skill in one environment, and its two forms.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "programs/pal/session/survey.hpp"

namespace pal::program {

struct Simulated {
  analyzer::Problem problem;
  std::string how;        // "random times, seeds 1 to 100, of at most 10 s each"
  std::size_t asked = 0;  // number of runs asked for
  std::size_t runs = 0;   // number of runs made; fewer if the time ran out
  std::size_t completed = 0;
  std::vector<Seen> seen;  // by requirement
  std::vector<std::string> run_names;
  std::vector<std::string> refused;  // scripts that cannot be followed
};

std::string text(const Simulated& simulated);
/// {"simulations": [{skill, environment, runs, completed, refused, requirements}]}
/// (docs/reference/simulation.md).
std::string json(const std::vector<Simulated>& simulations);

}  // namespace pal::program
