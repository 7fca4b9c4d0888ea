// Proofs that a run contradicts.
#pragma once

#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Whether the run that the verdict knows goes beyond what it says of all runs. Then the proof is wrong, by a
/// defect of the analysis.
bool is_refuted(const Verdict& verdict);

/// Where a run refutes one verdict of an analysis nothing of that analysis is used, in none of `verdicts`:
/// what fails by a run fails, all else of it is undecided, without a bound, and the explanation says why.
/// `verdicts` are of one skill, and so are `replaced`: others that are in their places now, but count as
/// what their analysis said.
void withdraw_refuted(std::vector<Verdict>& verdicts, const std::vector<Verdict>& replaced = {});

}  // namespace pal::analyzer
