// The caption of a chart of a run, in words.
#pragma once

#include "analyzer/chart/options.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// Of a verdict's run.
analyzer::chart::Caption proof_caption(const Proof& proof, std::size_t index);

/// "35 ms in this run, limit 10 ms, 25 ms too much": for a run of which nothing is proved.
std::string shown_figures(const analyzer::Requirement& requirement, Duration value);

}  // namespace pal::program
