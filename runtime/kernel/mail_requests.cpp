// Requests between their put and the take of their answer (docs/reference/execution-model.md, Messages).
#include <algorithm>

#include "runtime/kernel/devices.hpp"
#include "runtime/kernel/mail.hpp"

namespace pal::runtime {

void Mail::ask(Slot& request, const Thread* owner) {
  if (request.spec->answer >= 0) request.asked.push_back({owner, false, executive_.now()});
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
