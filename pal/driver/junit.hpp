// What `pal check` finds as a JUnit report, which CI services show as tests.
#pragma once

#include <string>
#include <vector>

#include "pal/driver/proof.hpp"

namespace pal::driver {

/// A suite for each skill in each environment, with a case for each requirement: it passes if it holds, fails
/// if not, and is an error if it is undecided. Before them a suite of the specification, with a case for each
/// file: its errors are the case's failures. The form is that of Ant's JUnit task, which has no norm.
std::string junit(const std::vector<Proof>& proofs, const Session& session);

}  // namespace pal::driver
