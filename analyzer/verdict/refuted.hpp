// Proofs that a run contradicts.
#pragma once

#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Whether the run that the verdict knows goes beyond what it says of all runs. Then the proof is wrong, by a
/// defect of the analysis.
bool is_refuted(const Verdict& verdict);

/// Where a run refutes one of `proofs` nothing of the analysis that it is of is used in `verdicts`: what
/// fails by a run fails, all else of it is undecided, without a bound, and the explanation says why. Both are
/// of one skill.
void withdraw_refuted(const std::vector<Verdict>& proofs, std::vector<Verdict>& verdicts);

/// The same, where the proofs are the verdicts.
void withdraw_refuted(std::vector<Verdict>& verdicts);

}  // namespace pal::analyzer
