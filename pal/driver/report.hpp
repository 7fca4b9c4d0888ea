// What `pal check` prints of the proofs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "pal/driver/proof.hpp"

namespace pal::driver {

/// A table: a line a requirement, with its verdict, bound, limit and margin.
void write_table(const std::vector<Proof>& proofs, std::ostream& out);

/// Classes explored and seconds taken, a line a proof.
void write_statistics(const std::vector<Proof>& proofs, std::ostream& out);

/// {"diagnostics": [...], "requirements": [{name, skill, environment, measure, limit_ns, bound_ns, exact,
/// verdict}]} (docs/command-line.md). bound_ns is null where there is no bound. Of a load, both figures are
/// nanoseconds of work a second.
std::string json(const std::vector<Proof>& proofs, const Session& session);

}  // namespace pal::driver
