// Findings and verdicts for editors and code hosts: the Static Analysis Results Interchange Format.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/session/exit_status.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"
#include "programs/pal/session/unchecked.hpp"

namespace pal::program {

/// A log of one run of `pal check` that ended with `status`, in SARIF 2.1.0 (OASIS, 2020; schema 2.1.0): a
/// result for each finding, with a place: what has none stands at the beginning of the first file. A
/// requirement that holds is no finding. Each of `not_checked` is a notification, an error if `required`,
/// else a warning. `any_verdict`: some requirement has one. Section numbers in the source are the standard's.
std::string sarif(const Session& session, const std::vector<Unchecked>& not_checked, bool required,
                  bool any_verdict, ExitStatus status, const std::string& remark = {});

/// The rules of these codes as JSON text: an array in the same order.
std::string sarif_rules(const std::vector<Code>& codes);

}  // namespace pal::program
