// Time that goes on for the physics and the devices alike, as a station lets it.
#pragma once

#include "runtime/drivers/timeline.hpp"
#include "sim/workcell.hpp"

namespace pal::sim::test {

inline void run(runtime::drivers::Timeline& timeline, Workcell& workcell, runtime::Time time) {
  const runtime::Time end = timeline.now() + time;
  while (timeline.next() <= end) {
    workcell.advance_to(timeline.next());
    timeline.advance_to(timeline.next());
  }
  workcell.advance_to(end);
  timeline.advance_to(end);
}

}  // namespace pal::sim::test
