// A world in which nothing moves by itself: for skills whose devices do everything.
#pragma once

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// `Dispatcher dispatcher(devices, world);` with a `StillWorld world;`: time goes from event to event.
class StillWorld final : public World {
 public:
  void advance_to(Time) override {}
  Time beat() override { return Time::max(); }
};

}  // namespace pal::runtime
