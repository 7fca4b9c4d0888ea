// What the proofs took, for --statistics.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// Of all proofs: sums, and the greatest peak of memory.
analyzer::Statistics sum_of(const std::vector<Proof>& proofs);

/// A line a requirement, and one for all.
void write_statistics(const std::vector<Proof>& proofs, std::ostream& out);

/// {states, classes, seconds, peak_bytes}.
std::string json(const analyzer::Statistics& statistics);

}  // namespace pal::program
