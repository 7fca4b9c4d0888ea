// The worst runs of a study's failures, a chart each.
#pragma once

#include <string>

#include "programs/pal/session/console.hpp"
#include "programs/pal/studies/study_proofs.hpp"
#include "study/table.hpp"

namespace pal::program {

struct WorstRuns {
  unsigned jobs = 0;   // 0: one for each core
  std::string folder;  // where POINT.SKILL.ENVIRONMENT.REQUIREMENT.svg goes
};

/// Proves each proof with a failure again, and draws the run of each requirement that fails. Says how many
/// were drawn, and of how many failures no run can be drawn.
void draw_worst_runs(const study::Table& table, StudyProofs& proofs, const WorstRuns& how,
                     const Console& console);

}  // namespace pal::program
