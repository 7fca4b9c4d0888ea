#pragma once

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// What the calling thread has had of the processors of this computer so far.
Time processor_time();

/// What two calls of processor_time() in a row differ by: the least of several pairs.
Time cost_of_processor_time();

}  // namespace pal::runtime
