// The part of a run that is measured: when it begins and ends, and what becomes of what is being measured
// then.
#include <algorithm>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {
namespace {

bool is_one_of(const Table<StepId, bool>& steps, StepId step) {
  return !steps.empty() && step.valid() && steps[step];
}

}  // namespace

/// Whether the phase may begin or end when it happens.
bool Firing::changes_phase(const Due& due) const {
  if (due.what != Due::What::go_on) return false;
  const StepId step = state_of(ThreadId::of(due.who)).at();
  if (is_one_of(watch_.phase.after, step) && !state_.in_phase) return true;
  return is_one_of(watch_.phase.during, step) != is_one_of(watch_.phase.during, due.next);
}

/// Whether something that is due may begin or end the phase, or lead to what does. Then all orders count.
bool Firing::phase_may_change() const {
  return limited() && std::any_of(due_.begin(), due_.end(), [this](const Due& due) {
           return due.what == Due::What::parent || due.what == Due::What::admit || changes_phase(due);
         });
}

/// The thread has done its statement.
void Firing::has_done(ThreadId thread) {
  if (!limited()) return;
  measure_now(thread);
  if (is_one_of(watch_.phase.after, state_of(thread).at()) && !state_.in_phase) begin_phase();
}

/// Some thread has come to another statement, or is over.
void Firing::follow_phase() {
  if (watch_.phase.during.empty()) return;
  const bool within =
      std::any_of(state_.threads.begin(), state_.threads.end(), [this](const ThreadState& thread) {
        return thread.status != Status::off && is_one_of(watch_.phase.during, thread.at());
      });
  if (within == state_.in_phase) return;
  if (within) {
    begin_phase();
  } else {
    end_phase();
  }
}

/// A reaction counts from here: what changes now is not reflected by anything that is known already.
void Firing::begin_phase() {
  state_.in_phase = true;
  const bool reacts = watch_.reaction && (watch_.kind == Watch::Kind::age || state_.counting);
  if (!reacts && watch_.kind != Watch::Kind::duration) return;
  state_.reference = now();
  ++phases_begun_;
}

/// What is still being measured does not count.
void Firing::end_phase() {
  state_.in_phase = false;
  state_.reference = tag::none;
  state_.lost.reset();
  if (watch_.kind == Watch::Kind::loss) {
    for (SlotState& of : state_.slots) of.carries = tag::none;
  }
  for (std::size_t i = 0; i < state_.pending.size(); ++i) {
    outcome_.over_gone = outcome_.over_gone || state_.pending[i] == Pending::over;
    state_.pending[i] = Pending::outside;
    pending_origin_[i] = Outcome::older_than_cap;
  }
}

}  // namespace pal::analyzer
