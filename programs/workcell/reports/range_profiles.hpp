// The range finder's profiles of a run, as plots that show how they can be interpreted.
#pragma once

#include <string>
#include <vector>

#include "sim/report/message_log.hpp"
#include "sim/report/plot.hpp"

namespace pal::workcell {

/// `profile`: the last one of the run; `profiles`: up to nine, evenly over the run, in one scale. Each with
/// its edge nearest to the middle and the two lines that make it, or without an edge its nearest point
/// (skills_pal/sensing). A skill may have followed another edge. None if no profile came.
std::vector<sim::Plot> range_plots(const sim::MessageLog& messages, const std::string& title);

}  // namespace pal::workcell
