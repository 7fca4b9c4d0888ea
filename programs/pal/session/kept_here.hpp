// The proof of one skill in one environment, as it is kept in a folder.
#pragma once

#include <optional>
#include <string>

#include "programs/pal/session/proof.hpp"
#include "study/proof_key.hpp"

namespace pal::program {

/// The word of --analysis.
const char* name(analyzer::AnalysisChoice choice);

/// What decides beside skill and environment.
study::KeyOptions key_options(const ProofLimits& limits);

/// The figures of an analysis.
study::KeptProof kept_form(const analyzer::Analysis& analysis);

/// Does nothing if the limits have no cache, or ask for bounds as textbooks have them.
class KeptHere {
 public:
  KeptHere(const pan::Network& skill, const pan::Environment& environment, const Session& session,
           const ProofLimits& limits);

  /// An analysis in which everything holds. What fails is proved again, for its story and its run.
  std::optional<analyzer::Analysis> find(const analyzer::Problem& problem) const;

  /// The analysis met no limit of time or memory.
  void keep(const analyzer::Analysis& analysis) const;

 private:
  const ProofLimits& limits_;
  std::string key_;    // empty: nothing is kept
  std::string texts_;  // a hash of all texts, if addends are asked for
};

}  // namespace pal::program
