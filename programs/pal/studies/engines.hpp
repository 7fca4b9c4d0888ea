// What makes the proofs of a study: the cores of this machine, GNU parallel, or Slurm. All leave them in the
// folder of proofs, so that the table is the same whoever made them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "programs/pal/session/console.hpp"
#include "programs/pal/studies/study_proofs.hpp"
#include "study/proof_store.hpp"

namespace pal::program {

enum class Engine { cores, parallel, slurm };

struct EngineOptions {
  Engine engine = Engine::cores;
  unsigned jobs = 0;        // at a time on each machine; 0: one for each core
  std::uint64_t block = 0;  // proofs of a job of another engine; 0: so many that it takes half a minute
  std::string hosts;        // GNU parallel's --sshloginfile; empty: this machine alone
  double patience = 1800;   // seconds after which a job queue in which no proof comes is given up
  std::string study;        // the study file
  std::string folder;       // of the study's results; logs of jobs go there
};

/// What is to be made, and where it goes.
struct EngineWork {
  StudyProofs& proofs;
  study::ProofStore& store;
  std::uint64_t all = 0;               // proofs of the study
  std::vector<std::uint64_t> missing;  // in order
};

/// The cores of this machine.
unsigned cores();

/// Makes a proof and keeps it. Throws std::runtime_error if it cannot be kept. After Ctrl-C nothing is kept.
void make_proof(std::uint64_t proof, EngineWork& work);

/// Whether it is kept, or what a limit left of it is.
bool is_made(std::uint64_t proof, const EngineWork& work);

/// Returns when the engine has done what it could, or after Ctrl-C, with what went wrong: a sentence each.
/// What is missing after that is for the caller to see.
std::vector<std::string> run_engine(EngineWork& work, const EngineOptions& options, const Console& console);

}  // namespace pal::program
