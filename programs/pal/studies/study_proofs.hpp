// The proofs of a study: each is a skill in an environment whose figures have the values of one point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"
#include "study/proof_key.hpp"
#include "study/study_file.hpp"
#include "study/table.hpp"

namespace pal::program {

/// Proof number p is pair p % pairs at point p / pairs. What it says is what `pal check` says of the same
/// skill with the figures written into its environment.
class StudyProofs {
 public:
  /// The session has been read without errors and outlives this object, as the study does. A pair is kept
  /// only if some requirement of it is asked for.
  StudyProofs(const study::Study& study, const Session& session, const ProofLimits& limits);

  /// What makes the study senseless before anything is proved: a figure that names nothing, a requirement
  /// that is not there, a skill without requirements. Nothing if it may begin.
  std::optional<study::Refusal> trouble() const;

  std::size_t pairs() const { return pairs_.size(); }
  /// The names of each pair.
  std::vector<study::Pair> pair_names() const;

  /// The name under which a proof is kept.
  std::string key(std::uint64_t proof);

  /// The name under which what was known is kept if the study's limit of time, or of memory, ends the proof.
  std::string limit_key(std::uint64_t proof);

  /// Makes it, in this thread. Nothing if a limit of time or memory ended it, or Ctrl-C: then it is not kept,
  /// and `at_limit` is what was known.
  std::optional<study::KeptProof> prove(std::uint64_t proof, study::KeptProof& at_limit);

  /// With its worst runs; nothing if the environment cannot be.
  std::optional<Proof> prove_thoroughly(std::uint64_t proof);

  /// The requirements of a pair that are asked for, with a verdict or with the reason why there is none.
  void add_rows(std::uint64_t proof, const study::KeptProof& kept, const std::string& note,
                study::Table& table);

 private:
  struct Made {
    const pan::Network* skill = nullptr;
    const pan::Environment* environment = nullptr;
    std::string skill_hash;
    // Those of its model, undecided; of a model that cannot be, those of the skill, not described.
    std::vector<std::pair<std::string, study::Row>> requirements;
  };
  /// The environment of a pair at a point; the changes are known to be possible.
  pan::Environment environment_at(std::uint64_t proof) const;
  std::optional<study::Refusal> trouble_of(const study::Figure& figure) const;
  std::optional<std::string> parameter_called(const std::string& name) const;
  bool asked_for(const std::string& requirement) const;
  std::uint32_t index_of(const std::string& text, std::vector<std::string>& texts) const;

  const study::Study& study_;
  const Session& session_;
  ProofLimits limits_;
  std::vector<Made> pairs_;
  std::vector<std::string> all_requirements_;    // of all skills, whether asked for or not
  std::uint64_t hashed_point_ = UINT64_MAX;      // whose environments are hashed
  std::vector<std::string> environment_hashes_;  // by pair; empty: not yet
};

}  // namespace pal::program
