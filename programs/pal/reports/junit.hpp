// What `pal check` finds as a JUnit report, which CI services show as tests.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// A suite for each skill in each environment, with a case for each requirement. A case passes if the
/// requirement holds, fails if it fails, and is an error if it is undecided. Before them comes a suite of the
/// specification, with a case for each file: its errors are the case's failures. The form is that of Ant's
/// JUnit task; there is no standard.
std::string junit(const std::vector<Proof>& proofs, const Session& session);

}  // namespace pal::program
