// The part of a run in which something counts (docs/reference/execution-model.md, What is measured).
#include <algorithm>

#include "tests/support/runs/all_runs.hpp"

namespace pal::test {

using namespace runs;

/// As it goes on.
void AllRuns::has_done(int thread) {
  if (!wanted_.limited()) return;
  weigh(thread);
  if (!s_.in_phase && wanted_.after.count(s_.threads[ix(thread)].at.back()) != 0) phase_begins();
}

void AllRuns::follow_loops() {
  if (wanted_.loops.empty()) return;
  bool within = false;
  for (const Thread& thread : s_.threads) {
    for (const auto& [module, at] : thread.at) {
      for (const auto& [looping, nodes] : wanted_.loops)
        within = within || (module == looping && at > nodes.first && at <= nodes.second);
    }
  }
  if (within && !s_.in_phase) phase_begins();
  if (!within && s_.in_phase) phase_ends();
}

void AllRuns::phase_begins() {
  s_.in_phase = true;
  say("  the phase begins");
  const bool reacts = wanted_.kind == Wanted::Kind::reaction ||
                      (wanted_.kind == Wanted::Kind::sample_reaction && s_.counting);
  if (reacts || wanted_.kind == Wanted::Kind::duration) s_.reference = birth();
}

void AllRuns::phase_ends() {
  s_.in_phase = false;
  say("  the phase ends");
  s_.reference = -1;
  s_.lost.clear();
  for (Slot& slot : s_.slots) slot.later = -1;
  if (wanted_.kind != Wanted::Kind::response) return;
  old_gone_ = old_gone_ || waits_long(s_);
  std::fill(s_.births.begin(), s_.births.end(), -1);
}

}  // namespace pal::test
