#include "executed_wiring.hpp"
#include "tests/golden/codegen/environments.hpp"

const pal::runtime::Wiring& pal::test::executed_elsewhere() {
  return pal::skills::executed::wiring();
}
