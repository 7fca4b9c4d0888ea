#include "analyzer/whatif/slack.hpp"

#include <algorithm>
#include <numeric>

namespace pal::analyzer {
namespace {

using Is = Verdict::State;

/// The model allows no longer time (problem.cpp).
constexpr Nanoseconds longest_time = 1'000'000'000'000'000;

/// By how much the steps get longer in which a growth is looked for that does not hold. Where a run fails it
/// leads back at once. A load has none that does, and a skill more classes the longer it may take.
constexpr Nanoseconds longer_steps = 100;
constexpr Nanoseconds longer_steps_of_loads = 4;

/// How an environment looks when some worst times have grown.
class Growth {
 public:
  __extension__ using Wide = __int128;

  Growth(const pan::Environment& environment, std::vector<std::string> names)
      : environment_(environment), names_(std::move(names)) {
    pan::Environment copy = environment;
    for (const std::string& name : names_)
      longest_ = std::max(longest_, find_figure(copy, name)->worst.count());
    single_ = names_.size() == 1;
  }

  Nanoseconds longest() const { return longest_; }
  Nanoseconds most() const { return longest_time - longest_; }

  /// `extra`: of the longest.
  pan::Environment by(Nanoseconds extra) const {
    pan::Environment grown = environment_;
    for (const std::string& name : names_) {
      Interval& time = *find_figure(grown, name);
      time.worst += Duration(share(time.worst.count(), extra));
      time.worst = std::min(time.worst, Duration(longest_time));
    }
    return grown;
  }

 private:
  Nanoseconds share(Nanoseconds worst, Nanoseconds extra) const {
    // Where all are 0 there is no proportion: all grow alike.
    if (single_ || longest_ == 0) return extra;
    return static_cast<Nanoseconds>((static_cast<Wide>(worst) * extra + longest_ - 1) / longest_);
  }

  const pan::Environment& environment_;
  std::vector<std::string> names_;
  Nanoseconds longest_ = 0;
  bool single_ = false;
};

class SlackSearch {
 public:
  SlackSearch(Judge& judge, const Problem& problem) : judge_(judge) {
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const bool load = problem.requirements[r].measure == Requirement::Measure::load;
      (load ? loads_ : timed_).push_back(r);
      all_.push_back(r);
    }
  }

  /// A growth that bounds alone show to hold, the greatest or nearly so.
  Nanoseconds bounded(const Growth& growth) {
    const Nanoseconds most = growth.most();
    Nanoseconds holds = 0;
    Nanoseconds open = most + 1;
    Nanoseconds step = std::max<Nanoseconds>(growth.longest(), 1'000);
    while (open - holds > 1 && !judge_.stopped()) {
      const bool looking = open > most;
      const Nanoseconds extra =
          looking ? (most - holds <= step ? most : holds + step) : holds + (open - holds) / 2;
      const auto problem = judge_.problem(growth.by(extra));
      (problem && judge_.bounded(*problem, all_) ? holds : open) = extra;
      step *= longer_steps;
    }
    if (holds == 0) return 0;
    const auto problem = judge_.problem(growth.by(holds));
    return problem && !judge_.has_zeno_run(*problem) ? holds : 0;
  }

  /// `known_to_hold`: so much more.
  void find(const Growth& growth, Nanoseconds known_to_hold, Slack& slack) {
    Nanoseconds most = growth.most();
    Known known = narrow(growth, known_to_hold, most, timed_, longer_steps);
    if (!loads_.empty()) {
      // Loads are asked last: never beyond what the others allow.
      const Known load = narrow(growth, known_to_hold, known.holds, loads_, longer_steps_of_loads);
      if (load.fails >= 0) {
        known.fails = load.fails;
        known.failing = load.failing;
      }
      if (load.holds < known.holds) known.open = load.open;
      known.holds = load.holds;
    }
    slack.holds = Duration(known.holds);
    slack.unlimited = known.holds == most;
    if (known.fails >= 0) slack.fails = Duration(known.fails);
    slack.requirement = known.fails >= 0 ? known.failing : known.open;
  }

 private:
  struct Known {
    Nanoseconds holds = 0;
    Nanoseconds fails = -1;  // -1: nothing is known to fail
    int failing = -1;        // requirement
    int open = -1;           // the last requirement that could not be decided
  };

  Ruling ask(const Growth& growth, Nanoseconds extra, const std::vector<std::size_t>& requirements) {
    const auto problem = judge_.problem(growth.by(extra));
    return problem ? judge_.ask(*problem, requirements) : Ruling{};
  }

  /// Greatest growth from `least`, which holds, up to `most` that is known to hold, and the least beyond it
  /// that is known to fail.
  Known narrow(const Growth& growth, Nanoseconds least, Nanoseconds most,
               const std::vector<std::size_t>& requirements, Nanoseconds longer) {
    const auto asker = [&](Nanoseconds extra) { return ask(growth, extra, requirements); };
    Known known;
    known.holds = least;
    Nanoseconds open = most + 1;  // nothing from here on is asked
    Nanoseconds step = std::max<Nanoseconds>(growth.longest(), 1'000);
    std::optional<Nanoseconds> below;  // the excess of `holds`, if it is known
    std::optional<Nanoseconds> above;  // of `open`
    const auto heard = [&](Nanoseconds extra, const Ruling& ruling) {
      if (ruling.state == Is::holds) {
        known.holds = extra;
        below = ruling.excess;
        return;
      }
      open = extra;
      above = ruling.excess;
      if (ruling.state != Is::fails) {
        known.open = ruling.requirement;
        return;
      }
      known.fails = extra;
      known.failing = ruling.requirement;
      sharpen(growth, requirements, known);
      open = known.fails;
    };
    if (least < most && most < growth.most())
      heard(most, asker(most));  // others allow no more: is it enough?
    while (known.holds < most && open > most && !judge_.stopped()) {
      const Nanoseconds extra = most - known.holds <= step ? most : known.holds + step;
      heard(extra, asker(extra));
      step *= longer;
    }
    bool next_to_failure = true;
    for (int n = 1; open - known.holds > 1 && !judge_.stopped(); ++n) {
      // The least growth with which a known run fails is often the least of all.
      const bool try_it = next_to_failure && known.fails == open;
      Nanoseconds extra = try_it ? open - 1 : known.holds + (open - known.holds) / 2;
      // Loads grow in proportion, or nearly so.
      if (below && above && n % 4 != 0) extra = crossing(known.holds, *below, open, *above);
      heard(extra, asker(extra));
      next_to_failure = !try_it || open < extra;  // sharpened: worth another try
    }
    // What could not be decided lies between: the least that fails.
    Nanoseconds low = open;
    while (known.fails - low > 1 && !judge_.stopped()) {
      const Nanoseconds middle = low + (known.fails - low) / 2;
      const Ruling ruling = asker(middle);
      if (ruling.state == Is::fails) {
        known.fails = middle;
        known.failing = ruling.requirement;
      } else {
        low = middle;
      }
    }
    return known;
  }

  /// Between two growths, one with and one without excess: where it begins, if it grows in proportion.
  static Nanoseconds crossing(Nanoseconds low, Nanoseconds below, Nanoseconds high, Nanoseconds above) {
    const Growth::Wide part =
        static_cast<Growth::Wide>(high - low) * -below / std::max<Nanoseconds>(above - below, 1);
    return std::clamp<Nanoseconds>(low + static_cast<Nanoseconds>(part), low + 1, high - 1);
  }

  /// Down to the least growth with which a known run fails: replays only.
  void sharpen(const Growth& growth, const std::vector<std::size_t>& requirements, Known& known) {
    Nanoseconds low = known.holds;
    while (known.fails - low > 1 && !judge_.stopped()) {
      const Nanoseconds middle = low + (known.fails - low) / 2;
      const auto problem = judge_.problem(growth.by(middle));
      const int refuted = problem ? judge_.refuted(*problem, requirements) : -1;
      if (refuted >= 0) {
        known.fails = middle;
        known.failing = refuted;
      } else {
        low = middle;
      }
    }
  }

  Judge& judge_;
  std::vector<std::size_t> timed_;
  std::vector<std::size_t> loads_;
  std::vector<std::size_t> all_;
};

}  // namespace

std::vector<Slack> slacks(const pan::Network& network, const pan::Environment& environment,
                          const Options& options) {
  std::vector<Slack> all;
  std::vector<std::string> names;
  for (const Figure& figure : figures(network, environment)) {
    all.push_back({figure.name, figure.time, {}, {}, false, -1});
    names.push_back(figure.name);
  }
  const Growth together(environment, names);
  all.push_back({"", {Duration(0), Duration(together.longest())}, {}, {}, false, -1});

  Judge judge(network, options);
  const auto problem = judge.problem(environment);
  if (!problem) return {};
  std::vector<std::size_t> everything(problem->requirements.size());
  std::iota(everything.begin(), everything.end(), std::size_t{0});
  const Ruling now = judge.ask(*problem, everything);
  SlackSearch search(judge, *problem);
  for (Slack& slack : all) {
    slack.requirement = now.requirement;
    if (now.state == Is::fails) slack.fails = Duration(0);
  }
  if (now.state != Is::holds) return all;
  const auto growth_of = [&](const Slack& slack) {
    return slack.figure.empty() ? together : Growth(environment, {slack.figure});
  };
  // What costs little is known of all before any is looked for further.
  std::vector<Nanoseconds> bounded;
  for (const Slack& slack : all) bounded.push_back(search.bounded(growth_of(slack)));
  for (std::size_t n = 0; n < all.size(); ++n) search.find(growth_of(all[n]), bounded[n], all[n]);
  return all;
}

}  // namespace pal::analyzer
