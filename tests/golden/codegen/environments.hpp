// The wirings of one skill for two environments, in one program.
#pragma once

#include "pal/runtime/wiring.hpp"

namespace pal::test {

const runtime::Wiring& executed_on_its_bench();
const runtime::Wiring& executed_elsewhere();

}  // namespace pal::test
