// What is measured of a run (docs/reference/execution-model.md, What is measured).
#include <algorithm>

#include "tests/support/runs/all_runs.hpp"

namespace pal::test {

using namespace runs;

namespace {

constexpr std::size_t most_births = 12;

}  // namespace

void AllRuns::begin_measuring() {
  if (wanted_.of_condition()) s_.known[ix(wanted_.condition)] = birth();
  if (wanted_.limited()) return;
  if (wanted_.kind == Wanted::Kind::reaction || wanted_.kind == Wanted::Kind::duration) {
    if (s_.births.empty()) birth();
    s_.reference = 0;
  }
}

int AllRuns::birth() {
  if (s_.births.size() >= most_births) throw TooMuch("too much is carried along");
  s_.births.push_back(0);
  return static_cast<int>(s_.births.size()) - 1;
}

void AllRuns::record(std::int64_t value) {
  greatest_ = std::max(greatest_, value);
  least_ = least_ < 0 ? value : std::min(least_, value);
  say("  measured " + std::to_string(value));
}

/// Time passes. What does not end, although it can, has no bound; what ends in another way does not count.
void AllRuns::grow(int time) {
  for (int& age : s_.births) age = age < 0 ? age : std::min(cap_, age + time);
  for (int& busy : s_.busy) {
    if (time > 0 && busy < -1) busy = -1;
    if (busy < 0) continue;
    busy = std::min(cap_, busy + time);
    if (wanted_.kind == Wanted::Kind::busy && busy == cap_) greatest_ = cap_;
  }
  const bool grows = wanted_.kind == Wanted::Kind::greatest || wanted_.kind == Wanted::Kind::reaction ||
                     wanted_.kind == Wanted::Kind::sample_reaction;
  if (grows && s_.reference >= 0 && s_.births[ix(s_.reference)] == cap_ && live()) greatest_ = cap_;
}

void AllRuns::measure(int thread) {
  if (!wanted_.limited()) weigh(thread);
}

void AllRuns::weigh(int thread) {
  Thread& of = s_.threads[ix(thread)];
  if (wanted_.at.count(of.at.back()) == 0) return;
  if (!in_question() && wanted_.kind != Wanted::Kind::response) return;
  switch (wanted_.kind) {
    case Wanted::Kind::age:
    case Wanted::Kind::sample_age:
      if (of.carries >= 0) record(s_.births[ix(of.carries)]);
      return;
    case Wanted::Kind::reaction:
    case Wanted::Kind::sample_reaction:
      if (s_.reference < 0 || of.carries <= s_.reference) return;
      record(s_.births[ix(s_.reference)]);
      s_.reference = of.carries;
      return;
    case Wanted::Kind::least:
    case Wanted::Kind::greatest:
      if (s_.reference >= 0) record(s_.births[ix(s_.reference)]);
      s_.reference = birth();
      return;
    case Wanted::Kind::response:
      respond(of);
      return;
    default:
      return;
  }
}

/// The event that the thread carries is answered; none that came before may be left.
void AllRuns::respond(Thread& of) {
  if (of.carries < 0) return;
  const int waited = s_.births[ix(of.carries)];
  if (waited >= 0) {
    record(waited);
    const auto before = s_.births.begin();
    s_.failed = s_.failed || std::any_of(before, before + of.carries, [](int age) { return age >= 0; });
  }
  forget(of.carries);
}

void AllRuns::forget(int event) {
  old_gone_ = old_gone_ || s_.births[ix(event)] >= cap_;
  s_.births.erase(s_.births.begin() + event);
  const auto renumber = [event](int& carries) {
    if (carries == event) {
      carries = -1;
    } else if (carries > event) {
      --carries;
    }
  };
  for (Thread& each : s_.threads) renumber(each.carries);
  for (Slot& each : s_.slots) {
    renumber(each.carries);
    renumber(each.serving_carries);
    renumber(each.due_carries);
  }
}

void AllRuns::has_read(int thread, int condition) {
  int& carries = s_.threads[ix(thread)].carries;
  if (wanted_.of_condition() && condition == wanted_.condition) carries = s_.known[ix(condition)];
  if (wanted_.of_samples()) carries = std::max(carries, s_.known[ix(condition)]);
}

void AllRuns::has_set(int thread, int condition) {
  if (wanted_.of_condition() && condition == wanted_.condition) s_.known[ix(condition)] = birth();
  if (wanted_.of_samples()) s_.known[ix(condition)] = s_.threads[ix(thread)].carries;
}

void AllRuns::has_taken(int thread, int channel) {
  const int carried = s_.slots[ix(channel)].carries;
  keeps(thread, network_.channels[ix(channel)].message, carried);
  int& carries = s_.threads[ix(thread)].carries;
  if (wanted_.kind == Wanted::Kind::response && carried >= 0) carries = carried;
  if (wanted_.of_samples()) carries = std::max(carries, carried);
}

/// Of a message without fields there is nothing to keep.
void AllRuns::keeps(int thread, pan::MessageId message, int carried) {
  if (wanted_.of_samples() && !network_.messages[message.index()].fields.empty())
    s_.kept[{s_.threads[ix(thread)].module, message.value}] = carried;
}

void AllRuns::uses(int thread, const std::vector<pan::MessageId>& messages) {
  Thread& of = s_.threads[ix(thread)];
  for (const pan::MessageId message : messages) {
    const auto found = s_.kept.find({of.module, message.value});
    if (found != s_.kept.end()) of.carries = std::max(of.carries, found->second);
  }
}

int AllRuns::sent_along(int thread) const {
  const bool along = wanted_.kind == Wanted::Kind::response || wanted_.of_samples();
  return along ? s_.threads[ix(thread)].carries : -1;
}

int AllRuns::sample() {
  const int made = birth();
  if (wanted_.kind != Wanted::Kind::sample_reaction) return made;
  if (wanted_.limited()) s_.counting = true;
  if (s_.reference < 0 && in_question()) s_.reference = made;
  return made;
}

/// What the message of an event carries.
int AllRuns::has_occurred(int channel) {
  if (wanted_.samples.count(channel) != 0) return sample();
  return -1;
}

/// What the answer to a request that a device takes now will carry. A frame is one sample for all.
int AllRuns::is_served(int request) {
  if (wanted_.kind == Wanted::Kind::response) return s_.slots[ix(request)].carries;
  if (wanted_.samples.count(network_.channels[ix(request)].answer.value) == 0) return -1;
  if (new_sample_) sample();
  new_sample_ = false;
  return static_cast<int>(s_.births.size()) - 1;
}

void AllRuns::has_completed(int code) {
  if (wanted_.kind == Wanted::Kind::duration && wanted_.code == code && in_question())
    record(s_.births[ix(s_.reference)]);
}

int AllRuns::error_code() const {
  for (const pan::Completion& completion : network_.skill.completions) {
    if (completion.kind == pan::Completion::Kind::error) return completion.code;
  }
  return -1;
}

/// A pause of no length does not count: one that has just begun is told by -2 less the period before.
void AllRuns::track_busy() {
  if (wanted_.kind != Wanted::Kind::busy) return;
  for (int p : wanted_.processors) {
    int& busy = s_.busy[ix(p)];
    const bool now = !s_.ended && s_.running[ix(p)] >= 0;
    if (!now && busy >= 0) record(busy);
    if (!now && busy >= 0) busy = -2 - busy;
    if (now && busy < 0) busy = std::max(0, -2 - busy);
  }
}

// Losses.

bool AllRuns::counts(int process) const {
  return wanted_.kind == Wanted::Kind::loss && processes_[ix(process)].name == wanted_.device;
}

/// One more of the device's events, answers or frames.
void AllRuns::occurrence(int process, bool lost) {
  if (!counts(process)) return;
  s_.counting = true;
  if (!in_question()) return;
  s_.lost.push_back(lost);
  for (Slot& slot : s_.slots) {
    if (slot.later >= 0) ++slot.later;
  }
  count_losses();
}

/// What was put is taken out of its slot unused.
void AllRuns::has_withdrawn(int channel) {
  const int later = s_.slots[ix(channel)].later;
  if (later < 0) return;
  s_.lost[s_.lost.size() - 1 - ix(later)] = true;
  count_losses();
}

void AllRuns::count_losses() {
  for (std::size_t from = 0; from < s_.lost.size(); ++from) {
    const std::size_t to = std::min(s_.lost.size(), from + ix(wanted_.in));
    const auto begin = s_.lost.begin();
    record(
        std::count(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to), true));
  }
}

/// Whether some event has waited for its response for as long as is told apart.
bool AllRuns::waits_long(const State& state) const {
  return wanted_.kind == Wanted::Kind::response &&
         std::any_of(state.births.begin(), state.births.end(), [this](int age) { return age >= cap_; });
}

// What need not be remembered.

bool AllRuns::live() const {
  return !s_.ended && std::any_of(s_.threads.begin(), s_.threads.end(),
                                  [this](const Thread& thread) { return leads(thread); });
}

/// What no thread carries is forgotten. An event that no thread carries is lost: how old it is does not
/// matter, only that it came before others.
void AllRuns::forget(State& state) const {
  std::vector<int*> carriers{&state.reference};
  for (Thread& thread : state.threads) carriers.push_back(&thread.carries);
  for (int& known : state.known) carriers.push_back(&known);
  for (auto& [of, carries] : state.kept) carriers.push_back(&carries);
  for (Slot& slot : state.slots) {
    carriers.push_back(&slot.carries);
    carriers.push_back(&slot.serving_carries);
  }
  if (!wanted_.at.empty() && wanted_.kind != Wanted::Kind::response && !live()) {
    for (int* carrier : carriers) *carrier = -1;
  }
  std::vector<bool> carried(state.births.size());
  for (const int* carrier : carriers) {
    if (*carrier >= 0) carried[ix(*carrier)] = true;
  }
  const bool remembers_lost = wanted_.kind == Wanted::Kind::response;
  std::vector<int> kept;
  std::vector<int> number(state.births.size(), -1);
  for (std::size_t b = 0; b < state.births.size(); ++b) {
    const bool lost_before = !kept.empty() && kept.back() == cap_ + 1;
    if (!carried[b] && (!remembers_lost || lost_before || state.births[b] < 0)) continue;
    number[b] = static_cast<int>(kept.size());
    kept.push_back(carried[b] ? state.births[b] : cap_ + 1);
  }
  for (int* carrier : carriers) {
    if (*carrier >= 0) *carrier = number[ix(*carrier)];
  }
  state.births = kept;
  // Rows that the next occurrences, or those that can still be withdrawn, may be in.
  int deepest = -1;
  for (const Slot& slot : state.slots) deepest = std::max(deepest, slot.later);
  const std::size_t row = ix(deepest < 0 ? wanted_.in - 1 : deepest + wanted_.in);
  if (state.lost.size() > 40) throw TooMuch("too many losses to remember");
  if (state.lost.size() > row)
    state.lost.erase(state.lost.begin(), state.lost.end() - static_cast<std::ptrdiff_t>(row));
}

}  // namespace pal::test
