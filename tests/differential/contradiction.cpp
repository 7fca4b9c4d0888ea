#include "tests/differential/contradiction.hpp"

#include <algorithm>

using namespace pal;
using namespace pal::analyzer;

namespace pal::test {
namespace {

std::string units(std::int64_t value) {
  return std::to_string(value) + " units";
}

/// Long-run fractions, in nanoseconds of work in a second, rounded up.
std::string contradiction_of_load(const Seen& seen, const Verdict& verdict) {
  const std::int64_t load = (seen.load.work * 1'000'000'000 + seen.load.time - 1) / seen.load.time;
  const std::string what = std::to_string(seen.load.work) + " in " + std::to_string(seen.load.time);
  if (verdict.bound && load > verdict.bound->count()) return "a run is busy for " + what;
  if (verdict.state == Verdict::State::holds && load > verdict.limit.count())
    return "a run exceeds the limit";
  if (!seen.complete || !verdict.exact) return {};
  if (verdict.bound && load != verdict.bound->count()) return "no run is busy for more than " + what;
  return {};
}

/// Of `cap` and beyond it is not known how much it is.
std::string contradiction_of_least(const Seen& seen, const Verdict& verdict, Duration unit, int cap) {
  const Nanoseconds least = seen.least * unit.count();
  if (seen.least >= 0 && verdict.state == Verdict::State::never) return "a run measures " + units(seen.least);
  if (seen.least >= cap) return {};
  if (seen.least >= 0 && verdict.bound && least < verdict.bound->count())
    return "a run comes down to " + units(seen.least);
  if (seen.least >= 0 && verdict.state == Verdict::State::holds && least < verdict.limit.count())
    return "a run falls below the limit";
  if (!seen.complete || !verdict.exact) return {};
  if (verdict.bound && least != verdict.bound->count())
    return "no run comes further down than " + units(seen.least);
  return {};
}

}  // namespace

std::string contradiction(const Wanted& wanted, const Seen& seen, const Verdict& verdict, Duration unit,
                          int cap) {
  using Kind = Wanted::Kind;
  if (wanted.kind == Kind::load) return contradiction_of_load(seen, verdict);
  if (wanted.kind == Kind::least) return contradiction_of_least(seen, verdict, unit, cap);
  const bool number = wanted.kind == Kind::loss;
  const Nanoseconds greatest = seen.greatest * (number ? 1 : unit.count());
  const bool fine = verdict.bound || verdict.state == Verdict::State::holds;
  if (seen.failed && fine) return "an event stays without a response";
  if (seen.unanswered && (fine || verdict.state == Verdict::State::never))
    return "an event waits for its response for ever";
  if (seen.least >= 0 && verdict.state == Verdict::State::never)
    return "a run measures " + std::to_string(seen.least);
  if (verdict.bound && seen.greatest <= cap && greatest > verdict.bound->count())
    return "a run attains " + std::to_string(seen.greatest);
  if (verdict.state == Verdict::State::holds && greatest > verdict.limit.count())
    return "a run exceeds the limit";
  const bool kept =
      !seen.failed && !seen.unanswered && seen.greatest < cap && greatest <= verdict.limit.count();
  if (seen.complete && kept && verdict.state == Verdict::State::fails) return "no run breaks it";
  if (!seen.complete || !verdict.exact || seen.greatest >= cap) return {};
  if (verdict.bound && std::max<Nanoseconds>(greatest, 0) != verdict.bound->count())
    return "no run attains more than " + std::to_string(seen.greatest);
  const bool responds = wanted.kind == Kind::response;
  if (!verdict.bound && responds && !seen.failed) return "no run leaves an event without a response";
  if (!verdict.bound && !responds && verdict.state != Verdict::State::never)
    return "no run exceeds " + std::to_string(seen.greatest);
  return {};
}

}  // namespace pal::test
