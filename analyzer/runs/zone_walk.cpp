#include "analyzer/runs/zone_walk.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "analyzer/runs/dice.hpp"

namespace pal::analyzer {
namespace {

/// One walk in so many begins at the start of the skill.
constexpr std::uint64_t fresh_once_in = 8;

/// After so many walks without a worse value the best one is given up.
constexpr std::size_t patience = 150;

/// To give a walk times takes about as long as so many steps.
constexpr std::size_t steps_of_times = 500;

/// Of what the skill leaves open, once in so many draws another way than the first is drawn; 0: any way.
constexpr std::uint64_t moods[] = {0, 4, 16};

class ZoneWalk {
 public:
  ZoneWalk(const Machine& machine, const ZoneWalkOptions& options)
      : machine_(machine), options_(options), dice_(1, 0) {}

  std::optional<Witness> run() {
    while (!done()) walk();
    return std::move(found_);
  }

 private:
  /// Where an event leads to.
  struct Step {
    Place place;  // without moves
    ZoneClass reached;
    ScriptedFiring firing;  // at any time
  };
  using Way = std::vector<std::shared_ptr<const Step>>;

  bool done() const { return found_ || steps_ >= options_.steps || (options_.stop && options_.stop()); }

  bool further(Nanoseconds value, Nanoseconds than) const {
    return machine_.watch().least ? value < than : value > than;
  }

  void walk() {
    ++steps_;
    dice_.draw_seldom(moods[dice_.drawn(static_cast<int>(std::size(moods)))]);
    Way way = beginning();
    const std::size_t end = way.size() + options_.length;
    std::optional<Nanoseconds> worst;
    std::size_t after = 0;  // so many events
    while (way.size() < end && !done()) {
      std::optional<Nanoseconds> measured;
      if (!go_on(way, measured)) break;
      if (way.back()->place.state.failed) return confirm(way, false);
      if (!measured || (worst && !further(*measured, *worst))) continue;
      worst = measured;
      after = way.size();
    }
    ++idle_;
    if (!worst) return;
    way.resize(after);
    keep(std::move(way), *worst);
  }

  /// The start, or the best walk up to some step: one of the last ones as often as any earlier ones.
  Way beginning() {
    if (idle_ > patience) best_.clear();
    if (best_.size() < 2 || dice_.below(fresh_once_in) == 0) return {start()};
    int bits = 1;
    while ((std::size_t{1} << bits) < best_.size()) ++bits;
    const std::size_t back = dice_.below(std::uint64_t{1} << (1 + dice_.drawn(bits)));
    Way way = best_;
    way.resize(best_.size() - std::min(back, best_.size() - 1));
    return way;
  }

  std::shared_ptr<const Step> start() {
    Move move = first_move(machine_, dice_);
    auto made = std::make_shared<Step>();
    follow(ZoneClass(), Dbm(1), move, 0, sources_, made->reached);
    made->firing = {-1, dice_.take_picks(), 0};
    made->place = {std::move(move.outcome.state), std::move(move.numbers), std::move(move.frozen), {}, false};
    return made;
  }

  /// Adds an event that can come next. False: there is none, or it cannot be followed.
  bool go_on(Way& way, std::optional<Nanoseconds>& measured) {
    const Place& here = way.back()->place;
    if (here.state.ended) return false;
    std::vector<std::size_t> left(here.timers.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    while (!left.empty()) {
      const auto drawn = left.begin() + dice_.drawn(static_cast<int>(left.size()));
      const std::size_t k = *drawn;
      left.erase(drawn);
      if (here.frozen[k]) continue;
      fired_ = way.back()->reached.zone;
      if (!fire_first(fired_, k + 1, here.frozen)) continue;
      dice_.take_picks();
      auto move = move_from(machine_, here, k, dice_);
      if (!move) continue;
      if (move->outcome.too_many) return false;
      auto made = std::make_shared<Step>();
      if (!follow(way.back()->reached, fired_, *move, here.timers.size(), sources_, made->reached)) continue;
      ++steps_;
      measured = value_of(*move, here.timers.size());
      made->firing = {move->timer, dice_.take_picks(), 0};
      made->place = {
          std::move(move->outcome.state), std::move(move->numbers), std::move(move->frozen), {}, false};
      way.push_back(std::move(made));
      return true;
    }
    return false;
  }

  /// The worst value that the event can measure.
  std::optional<Nanoseconds> value_of(const Move& move, std::size_t timers) const {
    const Outcome& outcome = move.outcome;
    std::optional<Nanoseconds> worst;
    if (outcome.lost >= 0) worst = outcome.lost;
    for (const int origin : outcome.measured) {
      if (origin == Outcome::older_than_cap) continue;
      Nanoseconds value = 0;
      if (origin >= 0) {
        const std::size_t observer = 1 + timers + static_cast<std::size_t>(origin);
        value =
            machine_.watch().least ? -fired_.at(observer, move.variable) : fired_.at(move.variable, observer);
      }
      if (!worst || further(value, *worst)) worst = value;
    }
    return worst;
  }

  void keep(Way way, Nanoseconds value) {
    if (further(value, machine_.watch().limit)) return confirm(way, value >= Dbm::unbounded);
    if (!best_.empty() && further(best_value_, value)) return;
    if (best_.empty() || further(value, best_value_)) idle_ = 0;
    best_value_ = value;
    best_ = std::move(way);
  }

  /// Where actions were preempted a zone may be larger than what can be: only a run counts.
  void confirm(const Way& way, bool endless) {
    steps_ += steps_of_times;
    std::vector<ScriptedFiring> path;
    for (const auto& step : way) path.push_back(step->firing);
    WitnessSearch search;
    search.quick = true;
    search.stop = options_.stop;
    search.measured = !way.back()->place.state.failed;
    if (endless) search.enough = machine_.watch().limit + 1;
    auto made = witness_along(machine_, std::move(path), search);
    if (!made || made->grows) return;
    if (made->failed || further(made->measured.value, machine_.watch().limit)) found_ = std::move(made);
  }

  const Machine& machine_;
  const ZoneWalkOptions& options_;
  Dice dice_;
  Dbm fired_;
  std::vector<Source> sources_;
  std::size_t steps_ = 0;
  std::size_t idle_ = 0;  // walks since the best value became worse
  Way best_;
  Nanoseconds best_value_ = 0;
  std::optional<Witness> found_;
};

}  // namespace

std::optional<Witness> walk_zones(const Problem& problem, const Requirement& requirement,
                                  const ZoneWalkOptions& options) {
  using Measure = Requirement::Measure;
  if (!fits_exploration(problem) || requirement.measure == Measure::load) return std::nullopt;
  const bool busy = requirement.measure == Measure::busy;
  for (const ProcessorId processor :
       busy ? requirement.processors : std::vector<ProcessorId>{ProcessorId{}}) {
    const Watch watch = watch_of(problem, requirement, processor);
    const Machine machine(problem, watch);
    auto found = ZoneWalk(machine, options).run();
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace pal::analyzer
