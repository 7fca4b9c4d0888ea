// What a run leaves behind: the only place where its files are composed.
#pragma once

#include <string>
#include <vector>

#include "pal/support/output.hpp"
#include "sim/program/comparison.hpp"
#include "sim/program/promise.hpp"
#include "sim/program/session.hpp"
#include "sim/program/sweep.hpp"

namespace pal::workcell {

/// trace.json, trace.chrome.json (for Perfetto), log.csv (the tool's way and the contact force, each
/// millisecond), run.json (what was asked and what came of it), atc.REQUIREMENT.svg for each promise and,
/// with a picture, arm.png; all in `folder`.
std::vector<OutputFile> run_files(const std::string& folder, const runtime::Skill& skill,
                                  const Session& session, const SessionResult& result,
                                  const std::vector<Promise>& promises);

/// sweep.csv, a line a run, and sweep.json, the figures over all of them.
std::vector<OutputFile> sweep_files(const std::string& folder, const std::vector<std::string>& skills,
                                    const std::vector<std::vector<SweepRun>>& sweeps,
                                    const std::optional<Comparison>& comparison);

}  // namespace pal::workcell
