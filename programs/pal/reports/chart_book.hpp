// All requirements of proofs with their runs, as one page.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/chart/html.hpp"
#include "pal/trace/trace.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// The page's content; it opens with requirement `index` of `first`, which is one of `proofs`. A measured run
/// is shown for each requirement of its skill.
analyzer::chart::Book book_of(const std::vector<Proof>& proofs, const Proof& first, std::size_t index,
                              const std::optional<trace::Trace>& measured);

}  // namespace pal::program
