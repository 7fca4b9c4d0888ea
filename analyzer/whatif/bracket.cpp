#include "analyzer/whatif/bracket.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pal::analyzer::whatif {
namespace {

__extension__ using Wide = __int128;

using Is = Verdict::State;

/// By how much the steps get longer in which a growth is looked for that does not hold. Where a run fails it
/// leads back at once. A load has none that does, and a skill more classes the longer it may take.
constexpr Nanoseconds longer_steps = 100;
constexpr Nanoseconds longer_steps_of_loads = 4;

/// The least first step.
constexpr Nanoseconds least_step = 1'000;

/// By how much the growth gets greater with which a failure is looked for.
constexpr Nanoseconds failure_steps = 4;

/// Such a part of a time is near enough at first.
constexpr Nanoseconds rough = 32;

/// Ends that are further apart than this are halved by ratio.
constexpr Nanoseconds far_apart = 8;

/// Between two growths, one with and one without excess: where it begins, if it grows in proportion.
Nanoseconds crossing(Nanoseconds low, Nanoseconds below, Nanoseconds high, Nanoseconds above) {
  const Wide part = static_cast<Wide>(high - low) * -below / std::max<Nanoseconds>(above - below, 1);
  return std::clamp<Nanoseconds>(low + static_cast<Nanoseconds>(part), low + 1, high - 1);
}

}  // namespace

Bracket::Bracket(const Scaling& scaling, RequirementIds requirements, bool loads)
    : scaling_(scaling),
      requirements_(std::move(requirements)),
      longer_(loads ? longer_steps_of_loads : longer_steps),
      step_(std::max(scaling.longest(), least_step)) {}

Nanoseconds Bracket::tolerance(Precision precision) const {
  if (precision == Precision::exact) return 1;
  return std::max(least_step, (holds_ + scaling_.longest()) / rough);
}

/// Beyond that nothing is asked.
Nanoseconds Bracket::upper_end(Nanoseconds ceiling) const {
  return std::min(ceiling, fails_.value_or(ceiling));
}

/// Up to there it is not known whether everything holds.
Nanoseconds Bracket::lower_end(Nanoseconds ceiling) const {
  return undecided_ ? std::min(upper_end(ceiling), undecided_->first) : upper_end(ceiling);
}

bool Bracket::exhausted(Nanoseconds ceiling) const {
  if (requirements_.empty()) return true;
  if (lower_end(ceiling) - holds_ > 1) return false;
  return !undecided_ || upper_end(ceiling) - undecided_->second <= 1;
}

Nanoseconds Bracket::middle(Nanoseconds low, Nanoseconds high) const {
  const Nanoseconds base = scaling_.longest() + least_step;
  if ((high + base) / (low + base) < far_apart) return low + (high - low) / 2;
  const double ratio = std::sqrt(static_cast<double>(low + base) * static_cast<double>(high + base));
  return std::clamp<Nanoseconds>(static_cast<Nanoseconds>(ratio) - base, low + 1, high - 1);
}

Nanoseconds Bracket::step_up(Nanoseconds from, Nanoseconds ceiling) {
  const Nanoseconds extra = ceiling - 1 - from <= step_ ? ceiling - 1 : from + step_;
  step_ *= step_ < ceiling / longer_ ? longer_ : step_ < ceiling / 2 ? 2 : 1;
  return extra;
}

/// What to ask next; nothing: all is known that can be.
std::optional<Nanoseconds> Bracket::next(Nanoseconds tolerance, Nanoseconds ceiling, bool explores) {
  const Nanoseconds end = lower_end(ceiling);
  if (end - holds_ > tolerance) {
    if (hurried_ && !fails_ && *hurried_ < end) {
      // Less may be easier to decide. Then the same again.
      again_ = !again_;
      return again_ || *hurried_ - holds_ <= tolerance ? *hurried_ : middle(holds_, *hurried_);
    }
    const bool at_failure = fails_ == end;
    if (!at_failure && !undecided_) return step_up(holds_, ceiling);
    // Loads grow in proportion, or nearly so.
    if (below_ && above_ && asked_ % 4 != 3) return crossing(holds_, *below_, end, *above_);
    // The least growth with which a known run fails is often the least of all.
    const bool try_it = explores && next_to_failure_ && at_failure;
    return try_it ? end - 1 : middle(holds_, end);
  }
  if (!undecided_) return std::nullopt;
  const Nanoseconds upper = upper_end(ceiling);
  if (upper - undecided_->second <= tolerance) return std::nullopt;
  return fails_ == upper ? middle(undecided_->second, upper) : step_up(undecided_->second, ceiling);
}

void Bracket::hear(Nanoseconds extra, const Ruling& ruling) {
  assert(extra > holds_ && (!fails_ || extra < *fails_));
  const Nanoseconds end_before = lower_end(scaling_.most() + 1);
  if (ruling.state == Is::holds) {
    // The greater proof holds for all that is below, also where that could not be decided.
    if (undecided_ && undecided_->second <= extra) undecided_.reset();
    if (undecided_) undecided_->first = std::max(undecided_->first, extra + 1);
    holds_ = extra;
    below_ = ruling.excess;
  } else if (ruling.state == Is::fails) {
    fails_ = extra;
    failing_ = ruling.requirement;
    if (extra < end_before) above_ = ruling.excess;
    // A run that fails with less settles what was open above it.
    if (undecided_ && undecided_->first >= extra) undecided_.reset();
    if (undecided_) undecided_->second = std::min(undecided_->second, extra - 1);
  } else {
    open_ = ruling.requirement;
    undecided_ = undecided_
                     ? std::pair(std::min(undecided_->first, extra), std::max(undecided_->second, extra))
                     : std::pair(extra, extra);
    if (extra < end_before) above_.reset();
  }
  if (hurried_ && (extra == *hurried_ || holds_ >= *hurried_)) hurried_.reset();
  assert(!fails_ || holds_ < *fails_);
}

/// Down to the least growth with which a known run fails: replays only.
void Bracket::sharpen(RequirementChecker& checker, const Effort& effort) {
  Nanoseconds low = holds_;
  while (*fails_ - low > 1 && !effort.over()) {
    const Nanoseconds half = middle(low, *fails_);
    const auto problem = checker.problem(scaling_.by(half));
    const RequirementId refuted =
        problem ? checker.refuted(*problem, requirements_, effort.stop) : RequirementId();
    if (refuted.valid()) {
      hear(half, {Is::fails, refuted, {}});
    } else {
      low = half;
    }
  }
}

/// By bounds and single runs, with ever greater growths. Exploring one that is much too great may take all
/// the time, and a run shows at once that it fails.
void Bracket::look_for_failure(RequirementChecker& checker, const Effort& effort, Nanoseconds ceiling) {
  while (!fails_ && looked_up_to_ < ceiling - 1 && !effort.over()) {
    const Nanoseconds from = std::max(looked_up_to_, holds_);
    const Nanoseconds step = std::max(from, std::max(scaling_.longest(), least_step)) * (failure_steps - 1);
    const Nanoseconds extra = ceiling - 1 - from <= step ? ceiling - 1 : from + step;
    if (extra <= holds_) return;
    const auto problem = checker.problem(scaling_.by(extra));
    const Ruling ruling = problem ? checker.ask(*problem, requirements_, {0, effort.stop}) : Ruling{};
    if (ruling.state == Is::undecided && effort.over()) return;
    if (ruling.state != Is::undecided) hear(extra, ruling);
    looked_up_to_ = extra;
  }
}

void Bracket::narrow(RequirementChecker& checker, const Effort& effort, Precision precision,
                     Nanoseconds ceiling) {
  if (requirements_.empty()) return;
  if (effort.classes > classes_) undecided_.reset();
  classes_ = effort.classes;
  // Without exploration what bounds do not show is not shown to hold: only what fails is looked for.
  if (effort.classes == 0 && ceiling - holds_ > 1) undecided_ = {holds_ + 1, holds_ + 1};
  if (effort.classes > 0 && precision == Precision::exact) look_for_failure(checker, effort, ceiling);
  while (!effort.over()) {
    const auto extra = next(tolerance(precision), ceiling, effort.classes > 0);
    if (!extra) return;
    const auto problem = checker.problem(scaling_.by(*extra));
    const Ruling ruling = problem ? checker.ask(*problem, requirements_, effort) : Ruling{};
    const bool at_failure = fails_ && *extra == *fails_ - 1;
    ++asked_;
    if (ruling.state == Is::undecided && effort.over()) {
      // The next turn has more time, or decides another one.
      open_ = ruling.requirement;
      if (!at_failure) hurried_ = *extra;
      next_to_failure_ = !at_failure;
      return;
    }
    hear(*extra, ruling);
    if (ruling.state == Is::fails) sharpen(checker, effort);
    next_to_failure_ = !at_failure || (ruling.state == Is::fails && *fails_ < *extra);
  }
}

}  // namespace pal::analyzer::whatif
