#include "executed_wiring.hpp"
#include "tests/golden/codegen/environments.hpp"

const pal::runtime::Wiring& pal::test::executed_on_its_bench() {
  return pal::skills::executed::wiring();
}
