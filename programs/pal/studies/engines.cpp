#include "programs/pal/studies/engines.hpp"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "programs/pal/session/interruption.hpp"
#include "programs/pal/studies/job_engines.hpp"
#include "programs/pal/studies/progress.hpp"
#include "study/cores.hpp"

namespace pal::program {
namespace {

std::vector<std::string> run_here(EngineWork& work, const EngineOptions& options, const Console& console) {
  Progress progress(work.missing.size(), console);
  study::CoresWork cores_work;
  cores_work.pieces = work.missing.size();
  cores_work.processes = options.jobs > 0 ? options.jobs : cores();
  cores_work.work = [&work](std::size_t piece) { make_proof(work.missing[piece], work); };
  cores_work.progress = [&progress](std::size_t done) { progress.show(done); };
  cores_work.stop = Interruption::asked_for;
  std::vector<std::string> troubles;
  for (const std::string& death : study::run_on_cores(cores_work))
    troubles.push_back("a process of the study ended " + death);
  return troubles;
}

}  // namespace

unsigned cores() {
  // Those that this process may use, not those that there are.
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) == 0)
    return static_cast<unsigned>(std::max(1, CPU_COUNT(&set)));
  return std::max(1U, std::thread::hardware_concurrency());
}

void make_proof(std::uint64_t proof, EngineWork& work) {
  study::KeptProof at_limit;
  const auto made = work.proofs.prove(proof, at_limit);
  if (!made && Interruption::asked_for()) return;
  const auto trouble = made ? work.store.keep(work.proofs.key(proof), *made)
                            : work.store.keep(work.proofs.limit_key(proof), at_limit);
  if (trouble) throw std::runtime_error(*trouble);
}

bool is_made(std::uint64_t proof, const EngineWork& work) {
  return work.store.has(work.proofs.key(proof)) || work.store.has(work.proofs.limit_key(proof));
}

std::vector<std::string> run_engine(EngineWork& work, const EngineOptions& options, const Console& console) {
  switch (options.engine) {
    case Engine::cores:
      break;
    case Engine::parallel:
      return run_by_parallel(work, options, console);
    case Engine::slurm:
      return run_by_slurm(work, options, console);
  }
  return run_here(work, options, console);
}

}  // namespace pal::program
