// How a CONCURRENT ends, as far as conditions go.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pal/check/conditions/condition_concern.hpp"
#include "pal/check/conditions/condition_state.hpp"
#include "pal/pan/network.hpp"

namespace pal::check::conditions {

/// An SPC that a block finishes before it is cancelled.
struct LastSet {
  Thread block;
  pan::Set set;
  bool value = false;
};

struct Ending {
  State state;                  // the blocks are gone, their parent is behind the CONCURRENT
  std::optional<LastSet> last;  // of several the last one
};

/// All blocks of thread `parent` that can end have ended. Each of the others has stopped, or finishes its
/// current SPC.
std::vector<Ending> endings(const pan::Network& network, const Concern& concern, const State& state,
                            std::int32_t parent);

}  // namespace pal::check::conditions
