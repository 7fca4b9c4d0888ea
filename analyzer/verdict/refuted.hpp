// Proofs that are contradicted by a run.
#pragma once

#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Whether the verdict's own run goes beyond what the verdict says of all runs. Then the proof is wrong,
/// because of a defect of the analysis.
bool is_refuted(const Verdict& verdict);

/// Where a run refutes one of `proofs`, nothing of the analysis that gave this proof is used in `verdicts`.
/// What fails by a run fails; everything else of it is undecided, without a bound, and the explanation says
/// why. Both are of one skill.
void withdraw_refuted(const std::vector<Verdict>& proofs, std::vector<Verdict>& verdicts);

/// The same, where the proofs are the verdicts.
void withdraw_refuted(std::vector<Verdict>& verdicts);

}  // namespace pal::analyzer
