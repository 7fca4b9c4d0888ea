#include "analyzer/whatif/slack.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <thread>

#include "analyzer/whatif/figure_search.hpp"
#include "analyzer/zones/workers.hpp"
#include "pal/pan/times.hpp"

namespace pal::analyzer::whatif {
namespace {

using Is = Verdict::State;

/// Seconds for each figure in the first two rounds, and for all of them in the first one at most. Each
/// further round is longer by the last factor.
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

/// If the skill as it is was decided within this time, rounds with fewer classes than that took are left out.
/// So is the one without exploration.
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

/// So many figures have their turns at the same time, each with its part of the classes.
constexpr unsigned most_at_once = 4;

/// How the threads are shared between figures.
struct Sharing {
  unsigned at_once = 1;  // figures that have their turns at the same time
  unsigned threads = 0;  // of each; 0: one for each core
};

/// Without a clock one figure after the other, so that the answers are always the same.
Sharing sharing_of(std::size_t open, const Options& options) {
  if (!options.clock) return {1, options.threads};
  const unsigned all =
      std::max(1U, options.threads == 0 ? std::thread::hardware_concurrency() : options.threads);
  const unsigned at_once = std::min({all, most_at_once, static_cast<unsigned>(open)});
  return {at_once, all / at_once};
}

/// For several threads: asks one at a time whether to stop, and what time it is.
Options one_at_a_time(const Options& given) {
  const auto mutex = std::make_shared<std::mutex>();
  Options options = given;
  if (given.stop) {
    options.stop = [mutex, stop = given.stop] {
      const std::lock_guard lock(*mutex);
      return stop();
    };
  }
  if (given.clock) {
    options.clock = [mutex, clock = given.clock] {
      const std::lock_guard lock(*mutex);
      return clock();
    };
  }
  return options;
}

/// All figures, round by round.
class Rounds {
 public:
  Rounds(std::vector<Slack>& slacks, const RequirementChecker& checker, const SlackObserver& observer)
      : slacks_(slacks), checker_(checker), observer_(observer) {}

  void add(std::unique_ptr<FigureSearch> search) { searches_.push_back(std::move(search)); }

  /// `skipped`: rounds that are left out.
  void run(const RequirementIds& all, std::size_t skipped) {
    bool alone = false;  // a figure has its turn, with all threads and classes
    for (std::size_t number = 0; settled_ < slacks_.size() && !checker_.stopped(); ++number) {
      const Options& options = checker_.options();
      const Sharing sharing =
          alone ? Sharing{1, options.threads} : sharing_of(slacks_.size() - settled_, options);
      Options part = options;
      part.max_states /= sharing.at_once;  // the memory is shared
      Round round = round_of(number, skipped, slacks_.size(), part);
      const bool last_classes = round.last_classes;
      round.last_classes = last_classes && sharing.at_once == 1;
      Workers(sharing.at_once).each(slacks_.size(), 1, [&](std::size_t n) {
        if (!searches_[n] || checker_.stopped()) return;
        RequirementChecker checker(checker_, sharing.threads);
        turn(n, checker, round, all, number == 0);
      });
      alone = alone || (last_classes && exhausted());
    }
    for (std::size_t n = 0; n < slacks_.size(); ++n) {
      if (!searches_[n]) continue;
      searches_[n]->tell(slacks_[n]);
      slacks_[n].ended = true;
    }
  }

 private:
  /// What this round could decide of all figures that are open is decided.
  bool exhausted() const {
    return std::all_of(searches_.begin(), searches_.end(),
                       [](const auto& search) { return !search || search->exhausted(); });
  }

  void turn(std::size_t n, RequirementChecker& checker, const Round& round, const RequirementIds& all,
            bool first) {
    FigureSearch& search = *searches_[n];
    const Effort half = effort_of(round, checker.options(), 0.5);
    const Effort whole = effort_of(round, checker.options());
    search.bound(checker, all, half);
    search.narrow(checker, half, whole, first ? Precision::rough : Precision::exact);
    const std::lock_guard lock(mutex_);
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
  const RequirementChecker& checker_;
  const SlackObserver& observer_;
  std::vector<std::unique_ptr<FigureSearch>> searches_;  // by slack; null: settled
  std::mutex mutex_;                                     // of what is told, and of what is settled
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

std::vector<Slack> slacks(const pan::Network& network, const pan::Environment& given, const Options& options,
                          const SlackObserver& observer) {
  const pan::Environment environment = pan::with_times_of(network, given);
  RequirementChecker checker(network, one_at_a_time(options));
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

}  // namespace pal::analyzer::whatif
