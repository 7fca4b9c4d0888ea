// Requests from their put to the take of their answer.
#include "tests/support/runs/all_runs.hpp"

#include <algorithm>

namespace pal::test {

using namespace pan;
using namespace runs;

/// Whether the messages of the channel are requests that a module answers.
bool AllRuns::answered(int request) const {
  if (!network_.channels[ix(request)].answer.valid()) return false;
  const int process = receiver_process_[ix(request)];
  if (process < 0) return true;
  const std::vector<int>& served = processes_[ix(process)].requests;
  return std::find(served.begin(), served.end(), request) != served.end();
}

/// The oldest request that was taken and is not answered yet: what the next message of the channel answers.
std::optional<std::size_t> AllRuns::answered_next(int answer) const {
  const int request = request_of_[ix(answer)];
  if (request < 0) return std::nullopt;
  const Slot& of = s_.slots[ix(request)];
  std::size_t at = 0;
  if (s_.slots[ix(answer)].answers) at = 1;
  if (at >= of.asked.size()) return std::nullopt;
  if (of.full && at == of.asked.size() - 1) return std::nullopt;
  return at;
}

bool AllRuns::discards(int answer) const {
  const auto at = answered_next(answer);
  return at && s_.slots[ix(request_of_[ix(answer)])].asked[*at].withdrawn;
}

/// The next message of the channel is lost or discarded.
void AllRuns::answered_in_vain(int answer) {
  const auto at = answered_next(answer);
  if (!at) return;
  std::vector<Asked>& asked = s_.slots[ix(request_of_[ix(answer)])].asked;
  asked.erase(asked.begin() + static_cast<std::ptrdiff_t>(*at));
}

bool AllRuns::belongs_to(int request, int thread) const {
  const std::vector<Asked>& asked = s_.slots[ix(request)].asked;
  return std::any_of(asked.begin(), asked.end(),
                     [&](const Asked& each) { return each.owner == thread && !each.withdrawn; });
}

/// Withdraws what is open of a request: all of it, or what belongs to one thread. `freed` gets the channels
/// that are empty now.
void AllRuns::withdraw(int request, std::optional<int> owner, std::vector<int>& freed) {
  const int answer = network_.channels[ix(request)].answer.value;
  if (answer < 0) return;
  std::vector<Asked> before = std::move(s_.slots[ix(request)].asked);
  std::vector<Asked> after;
  const auto remove = [&](int channel) {
    say("dropped " + network_.messages[network_.channels[ix(channel)].message.index()].name);
    if (wanted_.events.count(channel) != 0 && s_.slots[ix(channel)].carries >= 0)
      forget(s_.slots[ix(channel)].carries);
    const int claimed = s_.slots[ix(channel)].claimed;
    if (claimed >= 0) s_.threads[ix(claimed)].withdrawn = true;
    has_withdrawn(channel);
    clear(channel);
    freed.push_back(channel);
  };
  const bool first_answered = s_.slots[ix(answer)].answers;
  const bool last_in_slot = s_.slots[ix(request)].full;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Asked& each = before[i];
    const bool meant = !each.withdrawn && (!owner || each.owner == *owner);
    if (!meant) {
      after.push_back(each);
    } else if (last_in_slot && i + 1 == before.size()) {
      remove(request);
    } else if (first_answered && i == 0) {
      remove(answer);
    } else {
      after.push_back({each.owner, true});
    }
  }
  s_.slots[ix(request)].asked = std::move(after);
}

/// What a block has open when it ends is its parent's.
void AllRuns::hand_over(int block, int parent) {
  for (Slot& slot : s_.slots) {
    for (Asked& asked : slot.asked) {
      if (asked.owner == block) asked.owner = parent;
    }
  }
}

}  // namespace pal::test
