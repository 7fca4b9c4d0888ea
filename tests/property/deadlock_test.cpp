// Leaving out orders of moves must not lose a dead end, nor make one longer.
#include <catch2/catch.hpp>

#include "pal/check/check.hpp"
#include "pal/check/deadlock/explore.hpp"
#include "pal/check/load.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "tests/support/random_talk.hpp"

using namespace pal;
using namespace pal::frontend;

namespace {

void agree(const pan::Network& network) {
  const Flow flow(network);
  const auto automata = deadlock::automata(network, flow);
  const auto some = deadlock::explore(automata);
  const auto all = deadlock::explore(automata, {}, false);
  if (!all.complete) return;
  REQUIRE(some.complete);
  REQUIRE(some.states <= all.states);
  REQUIRE(some.total.has_value() == all.total.has_value());
  REQUIRE(some.partial.has_value() == all.partial.has_value());
  REQUIRE(some.untaken == all.untaken);
  if (!some.total) return;
  REQUIRE(some.total->timely == all.total->timely);
  REQUIRE(some.total->run.size() == all.total->run.size());
}

}  // namespace

TEST_CASE("following fewer orders finds the same dead ends") {
  std::size_t with_dead_end = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    CAPTURE(seed);
    const auto text = test::RandomTalk(seed).text();
    INFO(text);
    MemoryFileSystem files;
    files.add("talk.pal", text);
    SourceManager sources;
    Diagnostics diagnostics;
    const auto specification = check(load(files, sources, {"talk.pal"}, diagnostics), diagnostics);
    REQUIRE(specification.skills.size() == 1);
    bool other_error = false;
    for (const auto& finding : diagnostics.all()) {
      const bool dead_end = finding.code == Code::PAL0521 || finding.code == Code::PAL0522;
      if (dead_end) ++with_dead_end;
      other_error = other_error || (finding.severity == Severity::error && !dead_end);
    }
    if (!other_error) agree(specification.skills.front());
  }
  REQUIRE(with_dead_end > 100);
}
