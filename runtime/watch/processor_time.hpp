// How much processor time a thread has had, for measurements.
#pragma once

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// The processor time of this computer that the calling thread has had so far.
Time processor_time();

/// The difference of two calls of processor_time() in a row: the least of several pairs.
Time cost_of_processor_time();

}  // namespace pal::runtime
