// Random chains: their bounds beside those of another analysis, and of their PAL text.
#include <catch2/catch.hpp>

#include "analyzer/compositional/compositional.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/holistic.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

TEST_CASE("a system of chains has the same bounds built directly and read from PAL") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const test::ChainSystem system = test::small_chains(seed);
    INFO("seed " << seed << "\n" << test::text_of(system));
    const auto skill = test::sound_skill(test::text_of(system));
    const Analysis read = compositional::analyze(*skill->problem);
    const Analysis built = compositional::analyze(test::problem_of(system));
    REQUIRE(read.verdicts.size() == built.verdicts.size());
    for (std::size_t r = 0; r < read.verdicts.size(); ++r)
      CHECK(read.verdicts[r].bound == built.verdicts[r].bound);
  }
}

TEST_CASE("bounds of chains do not exceed those of the holistic analysis") {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const test::ChainSystem system = test::random_chains(seed, test::benchmark_shape(seed));
    const auto holistic = test::holistic(system);
    const Analysis analysis = compositional::analyze(test::problem_of(system));
    for (std::size_t c = 0; c < holistic.size(); ++c) {
      INFO("seed " << seed << " chain " << c + 1);
      if (analysis.verdicts[c].bound && holistic[c])
        CHECK(analysis.verdicts[c].bound->count() <= *holistic[c]);
    }
  }
}
