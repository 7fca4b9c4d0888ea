// Frames, events and answers of a device that no thread takes.
#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

namespace {

/// How many of the last occurrences are remembered. They cover every row that one of them can still be in.
/// The number is doubled, because a message may be withdrawn after others have come.
unsigned remembered(int in) {
  return 2 * static_cast<unsigned>(in) - 1;
}

/// A mask of the latest occurrences.
Losses first_of(unsigned number) {
  return Losses().set() >> (Losses().size() - number);
}

}  // namespace

bool Firing::counts_losses(DeviceId device) const {
  return watch_.kind == Watch::Kind::loss && watch_.device == device;
}

/// Whether one of the answers that are due finds its slot free, and a thread that waits for it.
bool Firing::arrives(DeviceId device, const DeviceState::Served& served) const {
  const std::vector<ChannelId>& requests = problem_.devices[device].requests;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!served[i]) continue;
    const ChannelId answer = channel_of(requests[i]).answer;
    const bool free = state_.slots[answer].fill == SlotState::Fill::empty;
    if (free && !discards(answer)) return true;
  }
  return false;
}

/// One more of the device's frames, events or answers, and whether it is lost at once. A message that gets
/// into its slot carries how many came after it.
void Firing::occurrence(DeviceId device, bool lost) {
  if (!counts_losses(device)) return;
  state_.counting = true;
  if (!counts()) return;
  outcome_.passed = true;
  state_.lost <<= 1U;
  state_.lost[0] = lost;
  state_.lost &= first_of(remembered(watch_.in));
  for (const ChannelId c : state_.slots.ids()) {
    SlotState& of = state_.slots[c];
    if (channel_of(c).sender_device != device || of.carries == tag::none) continue;
    if (of.carries < remembered(watch_.in)) ++of.carries;
  }
  count_losses();
}

/// What was put is withdrawn. So many may have come after it that what was before it is forgotten. Then they
/// were all lost, because its slot was full. The exception: they came into other slots.
void Firing::lost_after_all(ChannelId channel) {
  const std::uint8_t since = slot(channel).carries;
  const DeviceId device = channel_of(channel).sender_device;
  if (!counts_losses(device) || since == tag::none) return;
  if (since >= watch_.in) {
    if (problem_.devices[device].requests.size() > 1) outcome_.too_many = true;
    return;
  }
  state_.lost[since] = true;
  count_losses();
}

void Firing::count_losses() {
  const Losses row = first_of(static_cast<unsigned>(watch_.in));
  for (Losses rest = state_.lost; rest.any(); rest >>= 1U)
    outcome_.lost = std::max(outcome_.lost, static_cast<int>((rest & row).count()));
  outcome_.lost = std::max(outcome_.lost, 0);
}

}  // namespace pal::analyzer
