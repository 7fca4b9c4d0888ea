// Witnesses on their way to a file, and back from it to be confirmed.
#pragma once

#include <iosfwd>
#include <vector>

#include "analyzer/replay/witness_file.hpp"
#include "pal/driver/proof.hpp"
#include "pal/driver/selection.hpp"

namespace pal::driver {

/// The witnesses of all verdicts that have one.
std::vector<analyzer::rules::FiledWitness> witnesses_of(const std::vector<Proof>& proofs, const Session& session);

/// Confirms or refutes each witness against the skills and environments of `session`, a line each. False: some could
/// not be confirmed.
bool confirm(const std::vector<analyzer::rules::FiledWitness>& witnesses, Session& session, std::ostream& out);

}  // namespace pal::driver
