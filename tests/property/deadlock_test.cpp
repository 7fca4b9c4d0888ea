// What the search for deadlocks says of a skill is what trying everything says.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "pal/check/check.hpp"
#include "pal/check/deadlock/explore.hpp"
#include "pal/check/load.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "tests/support/random_talk.hpp"
#include "tests/support/talk_oracle.hpp"

using namespace pal;
using namespace pal::frontend;

namespace {

test::TalkOracle::Length length(const std::vector<deadlock::Deed>& run, std::size_t deeds) {
  test::TalkOracle::Length result{0, 0};
  for (std::size_t i = 0; i < deeds; ++i) {
    const bool timely =
        run[i].kind == deadlock::Deed::Kind::gives_up || run[i].kind == deadlock::Deed::Kind::loses;
    result.first += timely ? 1 : 0;
    result.second += is_talk(run[i]) ? 1 : 0;
  }
  return result;
}

struct Seen {
  int compared = 0, total = 0, partial = 0, undelivered = 0, untaken = 0;
};

struct Blurred {
  int compared = 0, decided = 0, dead = 0;
};

void compare(const pan::Network& network, Seen& seen) {
  const auto expected = test::TalkOracle(network, 8'000).run();
  const Flow flow(network);
  const auto found = deadlock::explore(deadlock::automata(network, flow));
  if (!expected.complete || found.overflowed) return;
  ++seen.compared;
  REQUIRE(found.complete);
  REQUIRE(found.total.has_value() == expected.total.has_value());
  if (expected.total) {
    ++seen.total;
    CHECK(length(found.total->run, found.total->decided) == *expected.total);
    CHECK(found.total->timely == (expected.total->first > 0));
  }
  const bool partial = expected.dead && (!expected.total || expected.dead->first < expected.total->first);
  REQUIRE(found.partial.has_value() == partial);
  if (partial) {
    ++seen.partial;
    CHECK(length(found.partial->run, found.partial->decided) == *expected.dead);
  }
  std::set<std::size_t> untaken;
  for (const auto channel : found.untaken) untaken.insert(channel.index());
  CHECK(untaken == expected.untaken);
  std::map<std::size_t, test::TalkOracle::Length> undelivered;
  for (const auto& one : found.undelivered)
    undelivered[one.channel.index()] = length(one.run, one.run.size());
  CHECK(undelivered == expected.undelivered);
  seen.untaken += untaken.empty() ? 0 : 1;
  seen.undelivered += undelivered.empty() ? 0 : 1;
}

/// Counting only few withdrawn requests leaves more undecided, and changes nothing of what is said.
void compare_blurred(const pan::Network& network, int withdrawn, Blurred& seen) {
  const auto expected = test::TalkOracle(network, 8'000).run();
  if (!expected.complete) return;
  const Flow flow(network);
  deadlock::Limits limits;
  limits.withdrawn = withdrawn;
  const auto found = deadlock::explore(deadlock::automata(network, flow), limits);
  if (!found.blurred) return;
  ++seen.compared;
  CAPTURE(withdrawn, found.complete);
  if (found.total) {
    REQUIRE(expected.total);
    ++seen.dead;
    CHECK(length(found.total->run, found.total->decided) >=
          *expected.total);  // a shorter one may not be counted
  }
  if (found.partial) {
    REQUIRE(expected.dead);
    ++seen.dead;
  }
  for (const auto channel : found.untaken) CHECK(expected.untaken.contains(channel.index()));
  for (const auto& one : found.undelivered) CHECK(expected.undelivered.contains(one.channel.index()));
  if (!found.complete) return;
  ++seen.decided;
  CHECK(found.total.has_value() == expected.total.has_value());
  const bool partial = expected.dead && (!expected.total || expected.dead->first < expected.total->first);
  if (partial) CHECK(found.partial.has_value());
  CHECK(found.undelivered.size() == expected.undelivered.size());
}

}  // namespace

// PAL_SEEDS=N tries N skills, PAL_FIRST=M from the M-th on.
TEST_CASE("leaving out orders of moves changes nothing that is found") {
  const char* wish = std::getenv("PAL_SEEDS");
  const std::uint64_t seeds = wish != nullptr ? std::strtoull(wish, nullptr, 10) : 400;
  Seen seen;
  const char* from = std::getenv("PAL_FIRST");
  const std::uint64_t first = from != nullptr ? std::strtoull(from, nullptr, 10) : 1;
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
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
      other_error = other_error || (finding.severity == Severity::error && !dead_end);
    }
    if (!other_error) compare(specification.skills.front(), seen);
  }
  CAPTURE(seen.compared, seen.total, seen.partial, seen.undelivered, seen.untaken);
  CHECK(seen.compared > static_cast<int>(seeds / 2));
  CHECK(seen.total > 50);
  CHECK(seen.partial > 10);
  CHECK(seen.undelivered > 10);
  if (wish != nullptr)
    WARN("compared " << seen.compared << ", deadlocks " << seen.total << ", waits for ever " << seen.partial
                     << ", undelivered " << seen.undelivered << ", untaken " << seen.untaken);
}

TEST_CASE("withdrawn requests that are not counted change nothing of what is decided") {
  const char* wish = std::getenv("PAL_SEEDS");
  const std::uint64_t seeds = wish != nullptr ? std::strtoull(wish, nullptr, 10) : 200;
  Seen seen;
  Blurred blurred;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (const auto& text : {test::RandomPolling(seed).text(), test::RandomTalk(seed).text()}) {
      CAPTURE(seed);
      INFO(text);
      MemoryFileSystem files;
      files.add("talk.pal", text);
      SourceManager sources;
      Diagnostics diagnostics;
      const auto specification = check(load(files, sources, {"talk.pal"}, diagnostics), diagnostics);
      REQUIRE(specification.skills.size() == 1);
      compare(specification.skills.front(), seen);
      for (const int withdrawn : {0, 1, 2}) compare_blurred(specification.skills.front(), withdrawn, blurred);
    }
  }
  CAPTURE(blurred.compared, blurred.decided, blurred.dead);
  CHECK(blurred.compared > static_cast<int>(seeds / 2));
  CHECK(blurred.decided > static_cast<int>(seeds / 4));
  CHECK(blurred.dead > static_cast<int>(seeds / 20));
  if (wish != nullptr)
    WARN("compared " << seen.compared << "; blurred " << blurred.compared << ", of these decided "
                     << blurred.decided << ", dead ends found " << blurred.dead);
}
