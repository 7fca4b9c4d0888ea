// The files of a run. They are composed only here.
#pragma once

#include <string>
#include <vector>

#include "pal/support/output.hpp"
#include "programs/workcell/reports/comparison.hpp"
#include "programs/workcell/session/promise.hpp"
#include "programs/workcell/session/session.hpp"
#include "programs/workcell/session/sweep.hpp"
#include "sim/report/plot.hpp"

namespace pal::workcell {

/// In `folder`, of a result that outlives the files:
/// - trace.json, and trace.chrome.json for Perfetto;
/// - log.csv (sim/report/log_table.hpp);
/// - run.json: what was asked and what came of it;
/// - atc.REQUIREMENT.svg for each promise;
/// - with a picture, arm.png.
std::vector<OutputFile> run_files(const std::string& folder, const runtime::Skill& skill,
                                  const Session& session, const SessionResult& result,
                                  const std::vector<Promise>& promises);

/// Force, position and path over the run, and the range finder's profiles, if it gave any. Parameters of the
/// skill in newtons are levels in the plot of the force. Two that are called min… and max… are a band.
sim::DrawnPlots run_plots(const runtime::Skill& skill, const Session& session, const SessionResult& result);

/// sweep.csv, a line a run, and sweep.json, the figures over all of them.
std::vector<OutputFile> sweep_files(const std::string& folder, const std::vector<std::string>& skills,
                                    const std::vector<std::vector<SweepRun>>& sweeps,
                                    const std::optional<Comparison>& comparison);

}  // namespace pal::workcell
