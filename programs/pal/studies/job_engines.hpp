// Proofs made by programs that hand out jobs. A job is `pal sweep STUDY --cells A..B`, here or on another
// machine that sees the same files.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/studies/engines.hpp"

namespace pal::program {

/// GNU parallel, with its job log. A log of the same jobs is gone on with.
std::vector<std::string> run_by_parallel(EngineWork& work, const EngineOptions& options,
                                         const Console& console);

/// Slurm: one array of jobs. A queue in which no proof comes for `options.patience` is cancelled.
std::vector<std::string> run_by_slurm(EngineWork& work, const EngineOptions& options, const Console& console);

/// All proofs in ranges "A..B", ends included, of `block` proofs each.
std::vector<std::string> blocks_of(std::uint64_t all, std::uint64_t block);

/// A word of a shell.
std::string shell_word(const std::string& text);

}  // namespace pal::program
