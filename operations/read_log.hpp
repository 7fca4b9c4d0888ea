// Reads the log of a run.
#pragma once

#include <vector>

#include "operations/executor.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::operations {

/// The steps of a log that StepLog wrote when `program` ran. Reports the first line that is not a step, or
/// whose icon the program does not have (PAL1018).
std::vector<Step> read_log(const SourceManager& sources, FileId file, const Program& program,
                           Diagnostics& diagnostics);

}  // namespace pal::operations
