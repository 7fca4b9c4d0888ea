#include "analyzer/whatif/slack.hpp"

#include <algorithm>
#include <memory>

#include "analyzer/whatif/bracket.hpp"

namespace pal::analyzer {
namespace {

using Is = Verdict::State;

/// Seconds for each figure in the first two rounds, for all of them in the first one at most, and by how much
/// longer each further round is.
constexpr double first_share = 0.5;
constexpr double first_round = 8;
constexpr double longer_share = 3;

/// Classes of a question in the rounds; then as many as the options allow.
constexpr std::size_t classes_of_rounds[] = {0, 20'000, 100'000};

/// One round: what a question may take, and what each figure may.
struct Round {
  std::size_t classes = 0;
  double seconds = 0;
  bool last_classes = false;  // more are not allowed
};

/// If the skill as it is was decided within this time, rounds with fewer classes than that took are left out,
/// and so is the one without exploration.
constexpr double soon = first_share / 2;

/// Number `number` of the rounds, from 0, when the first `skipped` are left out.
Round round_of(std::size_t number, std::size_t skipped, std::size_t figures, const Options& options) {
  Round round;
  const std::size_t step = number + skipped;
  const bool stepped = step < std::size(classes_of_rounds);
  round.classes = stepped ? std::min(classes_of_rounds[step], options.max_states) : options.max_states;
  round.last_classes = round.classes >= options.max_states && step > 0;
  round.seconds = first_share;
  if (number == 0) round.seconds = std::min(first_share, first_round / static_cast<double>(figures));
  for (std::size_t n = 1; n < number; ++n) round.seconds *= longer_share;
  return round;
}

/// Of a round that begins now, or of a `part` of it.
Effort effort_of(const Round& round, const Options& options, double part = 1) {
  if (!options.clock) return {round.classes, options.stop};
  const double end = options.clock() + part * round.seconds;
  return {round.classes,
          [stop = options.stop, clock = options.clock, end] { return (stop && stop()) || clock() > end; }};
}

/// The search for the slack of one figure, or of all together.
class FigureSearch {
 public:
  FigureSearch(const pan::Environment& environment, std::vector<std::string> names, const Problem& problem)
      : scaling_(environment, std::move(names)),
        timed_(scaling_, requirements_that(problem, false), false),
        loads_(scaling_, requirements_that(problem, true), true),
        unbounded_(scaling_.most() + 1),
        step_(std::max<Nanoseconds>(scaling_.longest(), 1'000)) {}

  /// Looks for the greatest growth that bounds alone show to hold. Goes on where the last effort ended.
  void bound(RequirementChecker& checker, const RequirementIds& all, const Effort& effort) {
    const Nanoseconds before = bounded_;
    while (unbounded_ - bounded_ > 1 && !effort.over()) {
      const bool looking = unbounded_ > scaling_.most();
      const Nanoseconds up = scaling_.most() - bounded_ <= step_ ? scaling_.most() : bounded_ + step_;
      const Nanoseconds extra = looking ? up : bounded_ + (unbounded_ - bounded_) / 2;
      const auto problem = checker.problem(scaling_.by(extra));
      (problem && checker.bounded(*problem, all) ? bounded_ : unbounded_) = extra;
      step_ = step_ < scaling_.most() / 100 ? step_ * 100 : scaling_.most();
    }
    if (bounded_ == before) return;
    const auto problem = checker.problem(scaling_.by(bounded_));
    if (!problem || checker.has_zeno_run(*problem)) return;
    timed_.hold(bounded_);
    loads_.hold(bounded_);
  }

  /// Loads have half of the time, and what the others leave; these have what loads leave.
  void narrow(RequirementChecker& checker, const Effort& half, const Effort& whole, Precision precision) {
    timed_.narrow(checker, half, precision, ceiling_of(loads_));
    loads_.narrow(checker, whole, precision, ceiling_of(timed_));
    timed_.narrow(checker, whole, precision, ceiling_of(loads_));
  }

  bool exact() const { return holds() == scaling_.most() || (fails() && *fails() - holds() == 1); }
  /// What this round could decide is decided.
  bool exhausted() const {
    return exact() || (timed_.exhausted(ceiling_of(loads_)) && loads_.exhausted(ceiling_of(timed_)));
  }

  void tell(Slack& slack) const {
    slack.holds = Duration(holds());
    slack.unlimited = holds() == scaling_.most();
    if (fails()) slack.fails = Duration(*fails());
    const bool timed_says = fails() ? timed_.fails() == fails() : timed_.holds() == holds();
    const bool loads_only = timed_.requirements().empty();
    slack.requirement = (timed_says && !loads_only ? timed_ : loads_).requirement();
  }

 private:
  static RequirementIds requirements_that(const Problem& problem, bool are_loads) {
    RequirementIds chosen;
    for (const RequirementId r : requirements_of(problem)) {
      const bool load = problem.requirements[r.index()].measure == Requirement::Measure::load;
      if (load == are_loads) chosen.push_back(r);
    }
    return chosen;
  }

  /// What is of no interest to the others: something fails there.
  Nanoseconds ceiling_of(const Bracket& bracket) const {
    return bracket.fails().value_or(scaling_.most() + 1);
  }

  Nanoseconds holds() const {
    if (timed_.requirements().empty())
      return loads_.requirements().empty() ? scaling_.most() : loads_.holds();
    return loads_.requirements().empty() ? timed_.holds() : std::min(timed_.holds(), loads_.holds());
  }
  std::optional<Nanoseconds> fails() const {
    if (!timed_.fails() || !loads_.fails()) return timed_.fails() ? timed_.fails() : loads_.fails();
    return std::min(timed_.fails(), loads_.fails());
  }

  const Scaling scaling_;
  Bracket timed_;
  Bracket loads_;
  Nanoseconds bounded_ = 0;  // holds by bounds alone
  Nanoseconds unbounded_;    // does not; beyond the greatest growth: not looked for
  Nanoseconds step_;
};

/// All figures, round by round.
class Rounds {
 public:
  Rounds(std::vector<Slack>& slacks, RequirementChecker& checker, const SlackObserver& observer)
      : slacks_(slacks), checker_(checker), observer_(observer) {}

  void add(std::unique_ptr<FigureSearch> search) { searches_.push_back(std::move(search)); }

  /// `skipped`: rounds that are left out.
  void run(const RequirementIds& all, std::size_t skipped) {
    for (std::size_t number = 0; settled_ < slacks_.size() && !checker_.stopped(); ++number) {
      const Round round = round_of(number, skipped, slacks_.size(), checker_.options());
      for (std::size_t n = 0; n < slacks_.size(); ++n) {
        if (!searches_[n] || checker_.stopped()) continue;
        turn(n, round, all, number == 0);
      }
    }
    for (std::size_t n = 0; n < slacks_.size(); ++n) {
      if (!searches_[n]) continue;
      searches_[n]->tell(slacks_[n]);
      slacks_[n].ended = true;
    }
  }

 private:
  void turn(std::size_t n, const Round& round, const RequirementIds& all, bool first) {
    FigureSearch& search = *searches_[n];
    const Effort half = effort_of(round, checker_.options(), 0.5);
    const Effort whole = effort_of(round, checker_.options());
    search.bound(checker_, all, half);
    search.narrow(checker_, half, whole, first ? Precision::rough : Precision::exact);
    const bool settled = search.exact() || (round.last_classes && !first && search.exhausted());
    if (settled) {
      search.tell(slacks_[n]);
      searches_[n].reset();
      ++settled_;
      if (observer_.settled) observer_.settled(slacks_[n]);
    }
    if (observer_.asked) observer_.asked(settled_, slacks_.size());
  }

  std::vector<Slack>& slacks_;
  RequirementChecker& checker_;
  const SlackObserver& observer_;
  std::vector<std::unique_ptr<FigureSearch>> searches_;  // by slack; null: settled
  std::size_t settled_ = 0;
};

/// So many rounds are asked what holds as things are, which is a third of the usual minute: remedies need the
/// rest.
constexpr std::size_t rounds_of_now = 5;

/// What holds as things are, and the round that found it.
struct RulingNow {
  Ruling ruling;
  std::size_t round = 0;
};

RulingNow ruling_now(RequirementChecker& checker, const Problem& problem, const RequirementIds& all) {
  for (std::size_t number = 0;; ++number) {
    const Round round = round_of(number, 0, 1, checker.options());
    const Effort effort = effort_of(round, checker.options());
    const Ruling ruling = checker.ask(problem, all, effort);
    const bool last =
        (round.last_classes && !effort.over()) || (checker.options().deadline && number + 1 == rounds_of_now);
    if (ruling.state != Is::undecided || last || checker.stopped()) return {ruling, number};
  }
}

}  // namespace

std::vector<Slack> slacks(const pan::Network& network, const pan::Environment& environment,
                          const Options& options, const SlackObserver& observer) {
  RequirementChecker checker(network, options);
  const auto problem = checker.problem(environment);
  if (!problem) return {};

  std::vector<Slack> all;
  std::vector<std::string> names;
  for (const Figure& figure : figures(network, environment)) {
    all.push_back({figure.name, figure.time, {}, {}, false, {}, false});
    names.push_back(figure.name);
  }
  const Scaling together(environment, names);
  all.push_back({"", {Duration(0), Duration(together.longest())}, {}, {}, false, {}, false});

  const RequirementIds everything = requirements_of(*problem);
  const double begun = options.clock ? options.clock() : 0;
  const auto [now, round] = ruling_now(checker, *problem, everything);
  const bool soon_decided = options.clock && options.clock() - begun < soon;
  if (now.state != Is::holds) {
    for (Slack& slack : all) {
      slack.requirement = now.requirement;
      if (now.state == Is::fails) slack.fails = Duration(0);
    }
    return all;
  }
  Rounds rounds(all, checker, observer);
  for (const Slack& slack : all) {
    rounds.add(std::make_unique<FigureSearch>(
        environment, slack.figure.empty() ? names : std::vector<std::string>{slack.figure}, *problem));
  }
  rounds.run(everything, soon_decided ? std::max<std::size_t>(round, 1) : 0);
  return all;
}

}  // namespace pal::analyzer
