// Findings and verdicts for editors and code hosts: the Static Analysis Results Interchange Format.
#pragma once

#include <string>
#include <vector>

#include "pal/driver/exit_status.hpp"
#include "pal/driver/proof.hpp"
#include "pal/driver/selection.hpp"

namespace pal::driver {

/// A log of one run of `pal check` that ended with `status`, in SARIF 2.1.0 (OASIS, 2020; schema 2.1.0): a
/// result a finding and one, of kind `pass`, a requirement that holds. Section numbers in the source are the
/// standard's.
std::string sarif(const std::vector<Proof>& proofs, const Session& session, ExitStatus status);

/// The rules of that log as JSON text: an array with each row of the table of findings, its number being the
/// row's.
std::string sarif_rules();

}  // namespace pal::driver
