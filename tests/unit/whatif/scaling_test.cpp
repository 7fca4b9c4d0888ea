#include "analyzer/whatif/scaling.hpp"

#include <catch2/catch.hpp>

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

pan::Environment with_times(Nanoseconds send, Nanoseconds read) {
  pan::Environment environment;
  environment.costs.send = {Duration(0), Duration(send)};
  environment.costs.read = {Duration(0), Duration(read)};
  return environment;
}

}  // namespace

TEST_CASE("one figure grows by what is asked, and its best time stays") {
  const pan::Environment before = with_times(100, 7);
  const Scaling scaling(before, {"SEND"});
  CHECK(scaling.longest() == 100);
  const pan::Environment after = scaling.by(33);
  CHECK(after.costs.send == Interval{Duration(0), Duration(133)});
  CHECK(after.costs.read == before.costs.read);
}

TEST_CASE("several figures grow in proportion to the longest, rounded up") {
  const pan::Environment before = with_times(100, 7);
  const pan::Environment after = Scaling(before, {"SEND", "READ"}).by(10);
  CHECK(after.costs.send.worst == Duration(110));
  CHECK(after.costs.read.worst == Duration(8));  // 0.7 more
}

TEST_CASE("figures that are all 0 grow alike") {
  const pan::Environment before = with_times(0, 0);
  const pan::Environment after = Scaling(before, {"SEND", "READ"}).by(10);
  CHECK(after.costs.send.worst == Duration(10));
  CHECK(after.costs.read.worst == Duration(10));
}

TEST_CASE("the longest time of the model is reached and not exceeded") {
  const pan::Environment before = with_times(100, 7);
  const Scaling scaling(before, {"SEND", "READ"});
  CHECK(scaling.by(scaling.most()).costs.send.worst == Duration(1'000'000'000'000'000));
}
