// Writes witnesses to a file, and reads them back to confirm them.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/run_checker/witness_file.hpp"
#include "analyzer/whatif/placement.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"

namespace pal::program {

/// The witnesses of all verdicts that have one.
std::vector<analyzer::run_checker::FiledWitness> witnesses_of(const std::vector<Proof>& proofs,
                                                              const Session& session);

/// A run that breaks a requirement, for each refuted placement for which a simulation or the analysis finds
/// one before `options.stop` returns true. `network` and `environment` are those of the session to which the
/// placements belong. Each run is turned into its text for the file (run_checker::filed_text) at once. There
/// may be thousands of runs, and little time may be left afterwards.
std::vector<std::string> filed_witnesses_of(const std::vector<analyzer::whatif::Placements>& placements,
                                            const pan::Network& network, const pan::Environment& environment,
                                            const analyzer::Options& options);

/// The witnesses in the file; says on `console.err` why they cannot be read.
std::optional<std::vector<analyzer::run_checker::FiledWitness>> read_witness_file(const std::string& path,
                                                                                  const Console& console);

/// Why the run of the witness does not show what it claims about a skill and an environment of `session`;
/// empty: it is confirmed.
std::string refusal(const analyzer::run_checker::FiledWitness& witness, Session& session);

/// Confirms or refutes each witness against the skills and environments of `session`, with one line each.
/// False: some could not be confirmed.
bool confirm(const std::vector<analyzer::run_checker::FiledWitness>& witnesses, Session& session,
             std::ostream& out);

}  // namespace pal::program
