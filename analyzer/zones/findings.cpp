// What an exploration finds on its way: the greatest value of each measure, which is the number of an exact
// bound, and values that grow.
#include <algorithm>

#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

void Findings::measured(const Peak& value, bool least) {
  const auto better = [&](const Peak& than) {
    return value.value >= 0 &&
           (than.value < 0 || (least ? value.value < than.value : value.value > than.value));
  };
  if (better(peak)) peak = value;
  if (!value.relaxed && better(certain)) certain = value;
}

void Findings::add(const Findings& later, bool least) {
  measured(later.peak, least);
  measured(later.certain, least);
  if (!failure) failure = later.failure;
  if (!growing) growing = later.growing;
  if (!beyond) beyond = later.beyond;
  if (stuck < 0) stuck = later.stuck;
  passed = passed || later.passed;
  over_cap = over_cap || later.over_cap;
  never_answered = never_answered || later.never_answered;
  grows_on = grows_on || later.grows_on;
  outgrown = outgrown || later.outgrown;
  relaxed = relaxed || later.relaxed;
}

void ZoneGraph::measure(int from, const Move& move, const Dbm& fired, std::size_t timers,
                        Findings& findings) const {
  const Outcome& outcome = move.outcome;
  const bool failed = outcome.state.failed && !findings.failure;
  findings.passed = findings.passed || outcome.passed;
  if (outcome.measured.empty() && outcome.lost < 0 && !failed) return;
  const bool least = machine_.watch().least;
  Peak peak;
  peak.parent = from;
  peak.timer = move.timer;
  peak.choices = move.choices;
  peak.relaxed = classes_[static_cast<std::size_t>(from)].relaxed;
  for (std::size_t i = 0; i < outcome.measured.size(); ++i) {
    peak.measured = outcome.measured[i];
    peak.step = outcome.measured_steps[i];
    if (peak.measured == Outcome::older_than_cap) {
      findings.over_cap = true;
      if (!findings.beyond) findings.beyond = peak;
      if (findings.beyond->value < 0) findings.beyond->value = cap_ + 1;
      continue;
    }
    const std::size_t observer = 1 + timers + static_cast<std::size_t>(std::max(peak.measured, 0));
    peak.value = peak.measured == Outcome::born_now ? 0
                 : least                            ? -fired.at(observer, move.variable)
                                                    : fired.at(move.variable, observer);
    findings.measured(peak, least);
  }
  if (outcome.lost >= 0) {
    peak.value = outcome.lost;
    peak.measured = Outcome::born_now;
    findings.measured(peak, false);
  }
  if (failed) findings.failure = peak;
}

/// What grows counts as soon as it is greater than the limit, whether it is ever measured or not.
void ZoneGraph::observe_growth(const Arrival& arrival, Findings& findings) const {
  const Watch& watch = machine_.watch();
  if (findings.growing || !watch.grows()) return;
  const State& state = arrival.move->outcome.state;
  for (int o = 0; o < state.observers; ++o) {
    const Nanoseconds value =
        arrival.made.zone.at(0, 1 + arrival.move->timers.size() + static_cast<std::size_t>(o));
    if (value <= watch.limit || !grows(state, watch, o)) continue;
    findings.growing = Peak{value,
                            arrival.made.parent,
                            arrival.move->timer,
                            arrival.move->choices,
                            o,
                            StepId{},
                            arrival.made.relaxed,
                            true};
    return;
  }
}

}  // namespace pal::analyzer
