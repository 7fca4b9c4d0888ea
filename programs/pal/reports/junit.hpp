// What `pal check` finds as a JUnit report, which CI services show as tests.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/unchecked.hpp"

namespace pal::program {

/// A suite for each skill in each environment, with a case for each requirement. A case passes if the
/// requirement holds, fails if it fails, and is an error if it is undecided or never measured. One of
/// `not_checked` is skipped, with the reason; if `required`, it is an error. Before them comes a suite of the
/// specification, with a case for each file: its errors are the case's failures, and a file that could not be
/// read is an error. The form fits the schemas of Maven's Surefire (of a suite) and of Jenkins.
std::string junit(const std::vector<Proof>& proofs, const std::vector<Unchecked>& not_checked, bool required,
                  const Session& session);

}  // namespace pal::program
