#include "analyzer/run_checker/requirement_monitor.hpp"

#include <algorithm>

namespace pal::analyzer::run_checker {

RequirementMonitor::RequirementMonitor(const Problem& problem, const Requirement* requirement,
                                       BusyFrom busy_from)
    : problem_(problem),
      requirement_(requirement),
      busy_from_(busy_from),
      threads_(problem.threads.size(), none),
      channels_(problem.channels.size(), none),
      serving_(problem.channels.size(), none),
      due_(problem.channels.size(), none),
      conditions_(problem.conditions.size(), none),
      kept_(problem.kept.size(), none),
      busy_since_(problem.processors.size()),
      paused_(problem.processors.size(), -1),
      working_(problem.processors.size()),
      occurrence_(problem.channels.size(), -1) {
  if (requirement != nullptr && requirement->phase.limits()) phase_ = &requirement->phase;
  if (phase_ != nullptr) at_.assign(problem.threads.size(), {});
  if (requirement == nullptr || !requirement->condition.valid()) return;
  // Until the first set, what a condition says dates from the start.
  conditions_[requirement->condition] = birth();
  if (phase_ == nullptr) reference_ = conditions_[requirement->condition];
}

bool RequirementMonitor::of_condition(pan::ConditionId condition) const {
  return requirement_ != nullptr && requirement_->condition == condition;
}

bool RequirementMonitor::of_samples() const {
  return requirement_ != nullptr && !requirement_->samples.empty();
}

bool RequirementMonitor::is_sample(ChannelId channel) const {
  return of_samples() && std::find(requirement_->samples.begin(), requirement_->samples.end(), channel) !=
                             requirement_->samples.end();
}

bool RequirementMonitor::is_event(ChannelId channel) const {
  return is(Measure::response) && requirement_->is_event(channel);
}

RequirementMonitor::BirthId RequirementMonitor::birth() {
  births_.push_back(now_);
  answered_.push_back(false);
  uncounted_.push_back(!counts());
  return BirthId(births_.size() - 1);
}

void RequirementMonitor::show(Nanoseconds born, StepId step) {
  const StatementId statement = !step.valid() ? StatementId{} : problem_.steps[step].statement;
  measured_.push_back({now_ - born, born, now_, statement});
}

void RequirementMonitor::begins(ThreadId block, ThreadId parent) {
  thread(block) = thread(parent);
}

void RequirementMonitor::ends(ThreadId index) {
  thread(index) = none;
  if (phase_ == nullptr) return;
  at_[index] = {};
  follow_loops();
}

void RequirementMonitor::reaches(ThreadId index, StepId step) {
  if (phase_ == nullptr) return;
  at_[index] = step;
  follow_loops();
}

void RequirementMonitor::passes(ThreadId index, StepId step) {
  judge(index, step);
  const bool begins = phase_ != nullptr && !phase_->after.empty() && !in_phase_;
  if (begins && phase_->after[step]) phase_begins();
}

void RequirementMonitor::follow_loops() {
  if (phase_->during.empty()) return;
  const bool within = std::any_of(at_.begin(), at_.end(),
                                  [this](StepId step) { return step.valid() && phase_->during[step]; });
  if (within && !in_phase_) phase_begins();
  if (!within && in_phase_) phase_ends();
}

/// What has been known by now reflects nothing that changes from now on.
void RequirementMonitor::phase_begins() {
  in_phase_ = true;
  begun_ = now_;
  const bool knows = sampled_ || (requirement_->condition.valid());
  if (is(Measure::reaction) && knows) reference_ = birth();
}

/// What has not come to its end does not count.
void RequirementMonitor::phase_ends() {
  in_phase_ = false;
  uncounted_.assign(births_.size(), true);
  reference_ = none;
  last_pass_.reset();
  lost_.clear();
  std::fill(occurrence_.begin(), occurrence_.end(), -1);
}

void RequirementMonitor::judge(ThreadId index, StepId step) {
  if (requirement_ == nullptr || requirement_->at.empty()) return;
  if (!requirement_->at[step]) return;
  if (!counts() && !is(Measure::response)) return;
  switch (requirement_->measure) {
    case Measure::age:
      if (thread(index) != none) show(births_[thread(index)], step);
      return;
    case Measure::response:
      return respond(index, step);
    case Measure::reaction:
      return react(index, step);
    case Measure::interval:
      if (last_pass_) show(*last_pass_, step);
      last_pass_ = now_;
      return;
    default:
      return;
  }
}

void RequirementMonitor::respond(ThreadId index, StepId step) {
  const BirthId event = thread(index);
  if (event == none || answered_[event]) return;
  answered_[event] = true;
  if (uncounted_[event]) return;
  for (const BirthId earlier : answered_.ids()) {
    if (earlier == event) break;
    if (!answered_[earlier] && !uncounted_[earlier]) failed_ = true;
  }
  show(births_[event], step);
}

/// What changes just after the last value that was reflected is reflected by a later one.
void RequirementMonitor::react(ThreadId index, StepId step) {
  if (reference_ == none || thread(index) <= reference_) return;
  show(births_[reference_], step);
  reference_ = thread(index);
}

void RequirementMonitor::completes(ThreadId, StepId step, int code) {
  if (is(Measure::duration) && requirement_->code == code && counts()) show(begun_, step);
}

void RequirementMonitor::skill_ends() {
  for (const ProcessorId p : busy_since_.ids()) idle(p);
  ended_ = true;
}

void RequirementMonitor::sets(ThreadId index, pan::ConditionId condition) {
  if (of_condition(condition)) conditions_[condition] = birth();
  if (of_samples()) conditions_[condition] = thread(index);
}

void RequirementMonitor::reads(ThreadId index, pan::ConditionId condition) {
  const BirthId known = conditions_[condition];
  if (of_condition(condition)) thread(index) = known;
  if (of_samples()) thread(index) = std::max(thread(index), known);
}

void RequirementMonitor::busy(ProcessorId processor) {
  if (!is(Measure::busy) || working_[processor]) return;
  working_[processor] = true;
  std::vector<Nanoseconds>& since = busy_since_[processor];
  if (paused_[processor] != now_) since.clear();
  const bool anew = since.empty() || (busy_from_ == BusyFrom::each_pause && since.back() != now_);
  if (anew) since.push_back(now_);
}

void RequirementMonitor::idle(ProcessorId processor) {
  if (!is(Measure::busy)) return;
  const std::vector<ProcessorId>& watched = requirement_->processors;
  if (std::find(watched.begin(), watched.end(), processor) == watched.end()) return;
  if (!working_[processor]) return;
  working_[processor] = false;
  for (const Nanoseconds born : busy_since_[processor]) show(born, StepId{});
  paused_[processor] = now_;
}

void RequirementMonitor::puts(ThreadId index, ChannelId to) {
  const BirthId carried = is(Measure::response) || of_samples() ? thread(index) : none;
  const bool answered = is(Measure::response) && carried != none && answered_[carried];
  channel(to) = is_event(to) ? birth() : answered ? none : carried;
}

void RequirementMonitor::takes(ThreadId index, ChannelId from) {
  const BirthId carried = channel(from);
  if (is(Measure::response)) {
    if (carried != none && !answered_[carried]) thread(index) = carried;
  } else if (of_samples()) {
    thread(index) = std::max(thread(index), carried);
    const KeptId kept = problem_.channels[from].kept;
    if (kept.valid()) kept_[kept] = carried;
  }
}

void RequirementMonitor::uses(ThreadId index, StepId step) {
  if (!of_samples()) return;
  for (const KeptId kept : problem_.steps[step].uses) thread(index) = std::max(thread(index), kept_[kept]);
}

void RequirementMonitor::writes(ThreadId index, StepId step) {
  if (!of_samples()) return;
  for (const KeptId kept : problem_.steps[step].writes) kept_[kept] = thread(index);
}

void RequirementMonitor::empties(ChannelId of) {
  channel(of) = none;
  occurrence_[of] = -1;
}

void RequirementMonitor::serves(ChannelId request, bool first) {
  BirthId& carried = serving_[request];
  carried = is(Measure::response) ? channel(request) : none;
  const ChannelId answer = problem_.channels[request].answer;
  if (!is_sample(answer)) return;
  carried = first || births_.empty() || births_.back() != now_ ? birth() : BirthId(births_.size() - 1);
  sampled_ = true;
  if (reference_ == none && counts()) reference_ = carried;
}

void RequirementMonitor::is_due(ChannelId request) {
  due_[request] = serving_[request];
}

void RequirementMonitor::event(DeviceId device, ChannelId of, bool lost) {
  const bool responds = is_event(of);
  if (lost) {
    failed_ = failed_ || (responds && counts());
    occurrence(device, true);
    return;
  }
  channel(of) = responds || is_sample(of) ? birth() : none;
  sampled_ = sampled_ || is_sample(of);
  if (is_sample(of) && reference_ == none && counts()) reference_ = channel(of);
  occurrence_[of] = counts() ? static_cast<int>(lost_.size()) : -1;
  occurrence(device, false);
}

void RequirementMonitor::answers(ChannelId of, bool lost) {
  if (lost) {
    failed_ = failed_ || (is_event(of) && counts());
    return;
  }
  const ChannelId request = problem_.channels[of].answers;
  channel(of) = is_event(of) ? birth() : due_[request];
  occurrence_[of] = counts() ? static_cast<int>(lost_.size()) : -1;
}

void RequirementMonitor::served(DeviceId device, bool lost) {
  occurrence(device, lost);
}

void RequirementMonitor::frame_for_nobody(DeviceId device) {
  if (occurred_) occurrence(device, true);
}

void RequirementMonitor::occurrence(DeviceId device, bool lost) {
  if (!is(Measure::loss) || requirement_->device != device) return;
  occurred_ = true;
  if (!counts()) return;
  lost_.push_back(lost);
  show_losses();
}

/// A message that was put is taken out of its slot unused. One that awaited a response does so no more.
void RequirementMonitor::withdrawn(ChannelId of) {
  if (is_event(of) && channel(of) != none) answered_[channel(of)] = true;
  const int index = occurrence_[of];
  if (!is(Measure::loss) || requirement_->device != problem_.channels[of].sender_device) return;
  if (index < 0 ||
      lost_.size() - static_cast<std::size_t>(index) > 2 * static_cast<std::size_t>(requirement_->in) - 1)
    return;
  lost_[static_cast<std::size_t>(index)] = true;
  show_losses();
}

/// The most lost in any row of `in`, as far back as a message that is withdrawn now can have lain.
void RequirementMonitor::show_losses() {
  const auto in = static_cast<std::size_t>(requirement_->in);
  const std::size_t first = lost_.size() < 2 * in - 1 ? 0 : lost_.size() - (2 * in - 1);
  Nanoseconds most = 0;
  for (std::size_t from = first; from < lost_.size(); ++from) {
    Nanoseconds lost = 0;
    for (std::size_t i = from; i < std::min(from + in, lost_.size()); ++i) lost += lost_[i] ? 1 : 0;
    most = std::max(most, lost);
  }
  measured_.push_back({most, now_, now_, {}});
}

std::optional<Nanoseconds> RequirementMonitor::growing_since() const {
  if (requirement_ == nullptr || ended_) return std::nullopt;
  switch (requirement_->measure) {
    case Measure::response:
      for (const BirthId event : births_.ids()) {
        if (!answered_[event] && !uncounted_[event]) return births_[event];
      }
      return std::nullopt;
    case Measure::reaction:
      if (reference_ == none) return std::nullopt;
      return births_[reference_];
    case Measure::interval:
      return requirement_->at_least ? std::nullopt : last_pass_;
    case Measure::busy:
      for (const ProcessorId processor : requirement_->processors) {
        if (working_[processor]) return busy_since_[processor].front();
      }
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace pal::analyzer::run_checker
