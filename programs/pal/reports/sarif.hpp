// Findings and verdicts for editors and code hosts: the Static Analysis Results Interchange Format.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/session/exit_status.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"

namespace pal::program {

/// A log of one run of `pal check` that ended with `status`, in SARIF 2.1.0 (OASIS, 2020; schema 2.1.0): a
/// result for each finding. A requirement that holds is no finding. Section numbers in the source are the
/// standard's.
std::string sarif(const Session& session, ExitStatus status);

/// The rules of these codes as JSON text: an array in the same order.
std::string sarif_rules(const std::vector<Code>& codes);

}  // namespace pal::program
