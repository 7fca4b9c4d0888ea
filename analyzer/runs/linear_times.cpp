#include "analyzer/runs/linear_times.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "analyzer/runs/interrupter.hpp"
#include "analyzer/runs/solver_context.hpp"

namespace pal::analyzer {
namespace {

/// Harder ones than this are given up: the bound is then only not called exact.
using Clock = std::chrono::steady_clock;

/// What takes longer is given up: the bound is then only not called exact.
constexpr auto longest_search = std::chrono::seconds(2);
/// So are those of more events, or with more pieces of work. With twice as many, Z3 works for 20 seconds and
/// cannot be interrupted.
constexpr std::size_t most_solved_events = 2000;
constexpr std::size_t most_pieces = 1000;

using ChosenTimes = std::optional<std::vector<Nanoseconds>>;

/// The constraints, as Z3 has them. Its optimizer would find the greatest by itself, but one that is
/// interrupted after it found times and before it took them crashes (Z3 4.8).
class Constraints {
 public:
  Constraints(z3::context& context, std::size_t count, const std::vector<Difference>& differences,
              const std::vector<Work>& works)
      : context_(context), solver_(context, z3::solver::simple()) {
    z3::params parameters(context);
    // It would keep a Ctrl-C to itself.
    parameters.set("ctrl_c", false);
    solver_.set(parameters);
    for (std::size_t i = 0; i < count; ++i)
      times_.push_back(i == 0 ? number(0) : context.int_const(("t" + std::to_string(i)).c_str()));
    for (const Difference& each : differences) {
      if (each.bound < Range::unbounded) solver_.add(between(each.from, each.to) <= number(each.bound));
    }
    for (const Work& work : works) {
      const z3::expr sum = sum_of(work);
      solver_.add(sum >= number(work.range.best));
      if (work.range.worst < Range::unbounded) solver_.add(sum <= number(work.range.worst));
    }
  }

  enum class Answer { found, none, unknown };

  /// Looks for times that keep all, the goal being at least so great. Throws z3::exception, also if it was
  /// interrupted.
  Answer look(const std::optional<Goal>& goal, Nanoseconds least, ChosenTimes& found) {
    solver_.push();
    if (goal) solver_.add(between(goal->from, goal->to) >= number(least));
    const z3::check_result result = solver_.check();
    const bool known = result != z3::sat || take(found);
    solver_.pop();
    if (result == z3::unknown || !known) return Answer::unknown;
    return result == z3::sat ? Answer::found : Answer::none;
  }

 private:
  z3::expr number(Nanoseconds value) const { return context_.int_val(static_cast<std::int64_t>(value)); }

  z3::expr between(std::size_t from, std::size_t to) const { return times_[to] - times_[from]; }

  /// The pieces as one flat sum. Z3 rewrites sums within sums one by one, which cannot be interrupted.
  /// Freeing them takes as long again.
  z3::expr sum_of(const Work& work) const {
    z3::expr_vector pieces(context_);
    pieces.push_back(number(0));
    for (const auto& [begin, end] : work.pieces) pieces.push_back(between(begin, end));
    return z3::sum(pieces);
  }

  /// False: a time is too great to be told.
  bool take(ChosenTimes& found) const {
    const z3::model model = solver_.get_model();
    std::vector<Nanoseconds> values;
    for (const z3::expr& time : times_) {
      std::int64_t value = 0;
      if (!model.eval(time, true).is_numeral_i64(value)) return false;
      values.push_back(value);
    }
    found = std::move(values);
    return true;
  }

  z3::context& context_;
  z3::solver solver_;
  std::vector<z3::expr> times_;
};

/// Makes the goal greater until it cannot be, in steps that are doubled, and halved where one was too wide.
/// `best` has the best times so far, also if this throws.
void make_greatest(Constraints& constraints, const Goal& goal, const Interrupter& interrupter,
                   ChosenTimes& best) {
  using Answer = Constraints::Answer;
  const auto value = [&] { return (*best)[goal.to] - (*best)[goal.from]; };
  if (value() >= goal.enough) return;
  Nanoseconds above = goal.enough;
  const Answer most = constraints.look(goal, above, best);
  if (most == Answer::found && above >= Range::unbounded) best.reset();
  if (most != Answer::none || goal.less_will_not_do) return;
  // What Z3 does before it solves heeds no interruption.
  for (Nanoseconds step = 1; value() + 1 < above && !interrupter.interrupted();) {
    const Nanoseconds tried = step < above - value() ? value() + step : above - 1;
    switch (constraints.look(goal, tried, best)) {
      case Answer::found:
        step *= 2;
        break;
      case Answer::none:
        above = tried;
        step = std::max<Nanoseconds>(1, (above - value()) / 2);
        break;
      case Answer::unknown:
        return;
    }
  }
}

bool too_large(std::size_t count, const std::vector<Work>& works) {
  std::size_t pieces = 0;
  for (const Work& work : works) pieces += work.pieces.size();
  return count > most_solved_events || pieces > most_pieces;
}

}  // namespace

ChosenTimes linear_times(std::size_t count, const std::vector<Difference>& differences,
                         const std::vector<Work>& works, const std::optional<Goal>& goal,
                         const std::function<bool()>& stop) {
  if ((stop && stop()) || too_large(count, works)) return std::nullopt;
  z3::context& context = solver_context();
  const Clock::time_point end = Clock::now() + longest_search;
  const auto over = [&stop, end] { return Clock::now() >= end || (stop && stop()); };
  ChosenTimes best;
  bool whole = false;
  try {
    Constraints constraints(context, count, differences, works);
    const Interrupter interrupter(over, [&context] { context.interrupt(); });
    constraints.look(std::nullopt, 0, best);
    if (best && goal && !interrupter.interrupted()) make_greatest(constraints, *goal, interrupter, best);
    whole = !interrupter.interrupted();
  } catch (const z3::exception&) {
  }
  if (!whole) renew_solver_context();
  return best;
}

}  // namespace pal::analyzer
