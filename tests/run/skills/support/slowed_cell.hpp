// A skill in a workcell that is too slow for one of its requirements, held against the same in workcell.pal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

/// The proof and the runs of a skill in a workcell: workcell.pal, or a slower one.
class Cell {
 public:
  explicit Cell(PhysicalRun wanted, std::size_t most_states = program::ProofLimits{}.max_states)
      : wanted_(std::move(wanted)), bounds_(wanted_.skill, wanted_.slower, most_states) {}

  workcell::SessionResult run(std::uint64_t seed = 1) {
    wanted_.seed = seed;
    auto result = test::run(wanted_);
    bounds_.observe(result.outcome.trace);
    return result;
  }
  bool fails(const std::string& requirement) const { return bounds_.fails(requirement); }
  // Of all runs so far, ms; of a requirement that has a proved bound.
  double observed(const std::string& requirement) const {
    return std::chrono::duration<double, std::milli>(bounds_.worst().at(requirement).observed).count();
  }
  bool within_proof() const { return bounds_.greatest_part() <= 1; }

 private:
  PhysicalRun wanted_;
  ProvedBounds bounds_;
};

inline PhysicalRun slowed(PhysicalRun wanted, const Slower& slower) {
  wanted.slower = slower;
  return wanted;
}

}  // namespace pal::test
