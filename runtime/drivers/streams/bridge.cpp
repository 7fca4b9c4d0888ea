#include "runtime/drivers/streams/bridge.hpp"

namespace pal::runtime::drivers {

Bridge::Bridge(Link& first, Link& second)
    : first_(first), second_(second), from_first_(second), from_second_(first) {
  first_.connect(&from_first_);
  second_.connect(&from_second_);
}

Bridge::~Bridge() {
  first_.connect(nullptr);
  second_.connect(nullptr);
}

}  // namespace pal::runtime::drivers
