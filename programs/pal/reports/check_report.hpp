// What `pal check` prints of the proofs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/unchecked.hpp"

namespace pal::program {

/// A table with a line for each requirement: its verdict, bound, limit and margin. With `explain`, the parts
/// of the bound stand below it.
void write_table(const std::vector<Proof>& proofs, bool explain, std::ostream& out);

/// The lines of that table for one proof. `at_work`: what is undecided by now is open.
std::vector<std::string> table_rows(const analyzer::Problem& problem, const analyzer::Analysis& analysis,
                                    bool at_work);

/// A line for each of them, with the reason.
void write_unchecked(const std::vector<Unchecked>& not_checked, std::ostream& out);

/// {"diagnostics": [...], "not_kept", "requirements": [{name, skill, environment, measure, limit_ns,
/// bound_ns, attained_ns, exact, analysis, verdict, addends}]} (docs/reference/command-line.md), with what
/// they took if `statistics`. A figure that is not known is null. Of a load, both figures are nanoseconds of
/// work a second.
///
/// Those of `not_checked` follow, with the verdict "not checked" and a `reason`.
std::string json(const std::vector<Proof>& proofs, const std::vector<Unchecked>& not_checked,
                 const Session& session, bool statistics = false);

}  // namespace pal::program
