// Requests between their put and the take of their answer (docs/reference/execution-model.md, Messages).
#include <algorithm>

#include "runtime/kernel/devices.hpp"
#include "runtime/kernel/mail.hpp"

namespace pal::runtime {

void Mail::ask(Slot& request, const Thread* owner) {
  if (request.spec->answer >= 0)
    request.asked.push_back({.owner = owner, .serial = request.serial, .put = executive_.now()});
}

/// Whether the request at place `at` is still in its slot. One that a device was given and does not forget is
/// withdrawn there and answered all the same.
bool Mail::in_slot(const Slot& request, std::size_t at) const {
  return request.full && at + 1 == request.asked.size();
}

/// The request that the next message of the slot answers: the oldest that was taken and is not answered yet.
Asked* Mail::next_of_its_requests(const Slot& answer) {
  Slot& request = at(answer.request_of);
  const std::size_t next = answer.answers ? 1 : 0;
  if (next >= request.asked.size() || in_slot(request, next)) return nullptr;
  return &request.asked[next];
}

/// The next message of the slot is lost or discarded.
void Mail::answered_in_vain(const Slot& answer) {
  const Asked* next = answered_next(answer);
  if (next == nullptr) return;
  std::vector<Asked>& asked = at(answer.request_of).asked;
  asked.erase(asked.begin() + (next - asked.data()));
}

// Answers of devices.

bool Mail::may_fail(int device) const {
  return !wiring_.times.empty() && wiring_.times[static_cast<std::size_t>(device)].may_fail;
}

Time Mail::least_answer(int device) const {
  return wiring_.times.empty() ? Time() : wiring_.times[static_cast<std::size_t>(device)].answer.best;
}

bool Mail::find_request(const Slot& answer, std::uint64_t serial) {
  Slot& request = at(answer.request_of);
  const std::vector<Asked>& asked = request.asked;
  // A device that does not mark itself busy takes a request when it answers it.
  const bool takes = request.full && request.handed && !devices_.marks_itself(answer.device);
  const std::size_t first = answer.answers ? 1 : 0, end = asked.size() - (request.full && !takes ? 1 : 0);
  const Time soonest = executive_.now() - least_answer(answer.device);
  std::size_t found = first;
  if (serial != 0) {
    while (found < end && static_cast<std::uint64_t>(asked[found].serial) != serial) ++found;
  } else {
    // One that is late and not wanted any more is lost, as soon as this can be the answer to the next one.
    while (found + 1 < end && asked[found].withdrawn && asked[found].late && asked[found + 1].put <= soonest)
      ++found;
    // As it may be the late answer to one that was given up.
    if (found < end && request.gone > 0 && asked[found].put > soonest) {
      --request.gone;
      return false;
    }
  }
  if (found >= end) return false;
  for (std::size_t passed = first; passed < found; ++passed) never_answered(answer);
  request.gone = 0;
  if (takes && asked.size() == first + 1) taken_by_device(request);
  return true;
}

void Mail::never_answered(const Slot& answer) {
  Slot& request = at(answer.request_of);
  const std::size_t next = answer.answers ? 1 : 0;
  if (next >= request.asked.size()) return;
  const int channel = index(answer);
  const Asked passed = request.asked[next];
  if (in_slot(request, next)) taken_by_device(request);
  if (!may_fail(answer.device) && !passed.withdrawn && !passed.late)
    promises_.left_out(answer.device, channel);
  promises_.forgotten(answer.device, false);
  request.asked.erase(request.asked.begin() + static_cast<std::ptrdiff_t>(next));
  ++request.gone;
  journal_.record_device(trace::Kind::drop, answer.device, channel, trace::no_answer);
}

void Mail::left_unanswered(int channel) {
  if (at(channel).request_of >= 0) never_answered(at(channel));
}

void Mail::late(int device) {
  Slot* oldest = nullptr;
  std::size_t place = 0;
  for (const int channel : parties_[static_cast<std::size_t>(device)].inbox) {
    Slot& request = at(channel);
    if (request.spec->answer < 0) continue;
    const std::size_t next = at(request.spec->answer).answers ? 1 : 0;
    if (next >= request.asked.size() || (in_slot(request, next) && !request.handed)) continue;
    if (oldest != nullptr && oldest->asked[place].serial < request.asked[next].serial) continue;
    oldest = &request;
    place = next;
  }
  if (oldest == nullptr) return;
  if (may_fail(device))
    never_answered(at(oldest->spec->answer));
  else
    oldest->asked[place].late = true;
}

/// The open requests that belong to `owner`; nullptr: all of them.
void Mail::withdraw(Slot& request, const Thread* owner) {
  if (request.asked.empty()) return;
  Slot& answer = at(request.spec->answer);
  const auto meant = [owner](const Asked& each) {
    return !each.withdrawn && (owner == nullptr || each.owner == owner);
  };
  // What a blocked sender puts from here on is not meant.
  const bool asking = request.full && meant(request.asked.back());
  const bool answered = answer.answers && meant(request.asked.front());
  const bool forgotten = asking && (!request.handed || devices_.withdraw_from(request.device, request.port));
  for (Asked& each : request.asked) each.withdrawn = each.withdrawn || meant(each);
  if (asking && forgotten) request.asked.pop_back();
  if (asking) drop(request);
  if (answered) drop(answer);
}

void Mail::hand_over(const Thread& block, const Thread& parent) {
  for (const int request : requests_) {
    for (Asked& each : at(request).asked) {
      if (each.owner == &block) each.owner = &parent;
    }
  }
}

}  // namespace pal::runtime
