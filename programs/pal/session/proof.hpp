// A skill's requirements proved in an environment: the stages from network to verdict, one after the other.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/analysis.hpp"
#include "analyzer/problem/problem.hpp"
#include "programs/pal/session/measure_text.hpp"
#include "programs/pal/session/selection.hpp"
#include "study/proof_store.hpp"

namespace pal::program {

/// What one skill can promise in one environment.
struct Proof {
  analyzer::Problem problem;
  analyzer::Analysis analysis;  // verdicts[i] is on problem.requirements[i]
  bool explored = true;         // by the exact analysis, which more time and states may help
  bool ended = false;           // by --timeout or Ctrl-C, as far as it had come
  bool ended_by_user = false;   // by Ctrl-C
  std::string file = {};        // of the skill, if another one has its name; else empty
  bool half_open = false;       // its bounds have half-open windows
  bool kept = false;            // by an earlier call: its verdicts hold, and have no runs
};

/// "touch in workcell", with the skill's file where its name is not enough.
std::string heading_of(const Proof& proof);

struct ProofLimits {
  std::size_t max_states = 1'000'000;  // a requirement
  std::size_t max_memory = 0;          // bytes; 0: half of what there is (memory_there_is)
  double seconds = 0;                  // of everything together; 0: as long as it takes
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();  // when they began
  analyzer::AnalysisChoice analysis = analyzer::AnalysisChoice::thorough;  // a drawing needs the worst run
  unsigned threads = 0;                                                    // at work; 0: one a core
  bool peak_memory = false;                                                // count it
  bool addends = false;                                                    // find what adds up to bounds
  study::ProofStore* cache =
      nullptr;  // proofs in which everything holds are taken from it; all are kept there
  /// True of what is not to be proved; empty: all is.
  std::function<bool(const pan::Network&, const pan::Environment&)> leaves_out = {};
  bool fresh = false;  // none is taken: runs or statistics are asked for
};

/// The model of `skill` in `environment`. If the environment lacks something that the skill needs: nothing,
/// and findings in the session.
std::optional<analyzer::Problem> problem_of(const pan::Network& skill, const pan::Environment& environment,
                                            Session& session);

/// The same, with findings in `diagnostics`.
std::optional<analyzer::Problem> problem_of(const pan::Network& skill, const pan::Environment& environment,
                                            const SourceManager& sources, Diagnostics& diagnostics);

/// Whether the skill is proved in this environment: of environments of one name, in those that its file sees,
/// or in all if it sees none of them.
bool is_of(const pan::Network& skill, const pan::Environment& environment,
           const check::Specification& specification);

/// The limits in the form that an analysis takes. Ctrl-C ends it, too, as long as an Interruption lives.
analyzer::Options options_of(const ProofLimits& limits);

/// True as soon as `options.stop` has said so: then what is undecided might be decided with more time or
/// memory.
std::shared_ptr<std::atomic<bool>> note_stop(analyzer::Options& options);

/// Whether it is time to end: after Ctrl-C (as long as an Interruption lives), or `seconds` after `begin` (0:
/// never).
std::function<bool()> end_after(
    double seconds, std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now());

/// Checks before the proofs end when half of the time is over, or after Ctrl-C.
void limit_checks(const ProofLimits& limits, Session& session);

/// What is said beside bounds with half-open windows.
constexpr const char* half_open_text =
    "half-open windows, as in textbooks: a job released at the instant at which another ends does not delay "
    "it; "
    "in PAL it may";

/// Called now and then while a proof is at work, with what is known by then.
using ProofObserver = std::function<void(const analyzer::Problem&, const analyzer::Analysis&)>;

/// Proves every skill of the session in each of its environments. After Ctrl-C the rest stays undecided, or
/// has no proof if not even its model was built. A proof that does not end soon then is left alone
/// (is_work_left). Reasons why a model cannot be built are added to the session's findings. `alive` is the
/// session, for work that is left alone; without it no model is given up while it is built.
std::vector<Proof> prove(Session& session, const ProofLimits& limits, const ProofObserver& observer = {},
                         const std::shared_ptr<const Session>& alive = {});

/// Whether every verdict is `holds`.
bool all_hold(const std::vector<Proof>& proofs);

/// What the verdict of a requirement that holds counts as lost (PAL0824); nothing, if it counts on nothing
/// so.
std::optional<PartialDiagnostic> taken_as_lost(const Proof& proof, std::size_t index);

/// Adds the finding that time stands still in some run (PAL0821).
void report_zeno_run(const analyzer::Problem& problem, const analyzer::ZenoRun& zeno_run, Session& session);

/// Searches a few classes for such a run, adds the finding, and returns whether there is one.
bool look_for_zeno_run(const analyzer::Problem& problem, Session& session);

/// Adds a finding for every requirement that fails or is undecided. It says where the requirement stands, and
/// which statement uses a value of which age or answers how late. It also says what the time was spent on:
/// the longest parts, or the `whole_story`.
void report_unmet(const std::vector<Proof>& proofs, bool whole_story, Session& session);

/// The same of one requirement; nothing if it holds.
void report_unmet(const Proof& proof, std::size_t index, bool whole_story, Diagnostics& diagnostics);

}  // namespace pal::program
