#include "analyzer/runs/linear_times.hpp"

#include <z3++.h>

#include <memory>

#include "analyzer/runs/overseer.hpp"

namespace pal::analyzer {
namespace {

/// Harder ones than this are given up: the bound is then only not called exact.
constexpr unsigned most_milliseconds = 2000;
/// So are those of more events, or with more pieces of work: with twice as many Z3 is at it for 20 seconds,
/// heeding neither its limit nor an interruption.
constexpr std::size_t most_events = 2000;
constexpr std::size_t most_pieces = 1000;

using Times = std::optional<std::vector<Nanoseconds>>;

z3::expr number(z3::context& context, Nanoseconds value) {
  return context.int_val(static_cast<std::int64_t>(value));
}

/// The pieces as one sum: sums within sums are each rewritten by itself, which nothing interrupts, and it
/// takes as long again until they are gone.
z3::expr sum_of(const Work& work, const std::vector<z3::expr>& times, z3::context& context) {
  z3::expr_vector pieces(context);
  pieces.push_back(number(context, 0));
  for (const auto& [begin, end] : work.pieces) pieces.push_back(times[end] - times[begin]);
  return z3::sum(pieces);
}

/// Throws z3::exception, also if it was interrupted too late.
Times solved(z3::context& context, std::size_t count, const std::vector<Difference>& differences,
             const std::vector<Work>& works, const std::optional<Goal>& goal,
             const std::function<bool()>& stop) {
  z3::optimize solver(context);
  z3::params parameters(context);
  parameters.set("timeout", most_milliseconds);
  // It would keep a Ctrl-C to itself.
  parameters.set("ctrl_c", false);
  solver.set(parameters);
  std::vector<z3::expr> times;
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(i == 0 ? number(context, 0) : context.int_const(("t" + std::to_string(i)).c_str()));
  }
  for (const Difference& each : differences) {
    if (each.bound >= Range::unbounded) continue;
    solver.add(times[each.to] - times[each.from] <= number(context, each.bound));
  }
  for (const Work& work : works) {
    const z3::expr sum = sum_of(work, times, context);
    solver.add(sum >= number(context, work.range.best));
    if (work.range.worst < Range::unbounded) solver.add(sum <= number(context, work.range.worst));
  }
  if (goal) {
    const z3::expr value = times[goal->to] - times[goal->from];
    if (goal->enough < Range::unbounded) {
      solver.add(value >= number(context, goal->enough));
    } else {
      solver.maximize(value);
    }
  }
  {
    const Overseer overseer(stop, [&context] { context.interrupt(); });
    if (solver.check() != z3::sat) return std::nullopt;
  }
  const z3::model model = solver.get_model();
  std::vector<Nanoseconds> found;
  for (const z3::expr& time : times) {
    std::int64_t value = 0;
    if (!model.eval(time, true).is_numeral_i64(value)) return std::nullopt;
    found.push_back(value);
  }
  return found;
}

bool too_large(std::size_t count, const std::vector<Work>& works) {
  std::size_t pieces = 0;
  for (const Work& work : works) pieces += work.pieces.size();
  return count > most_events || pieces > most_pieces;
}

}  // namespace

Times linear_times(std::size_t count, const std::vector<Difference>& differences,
                   const std::vector<Work>& works, const std::optional<Goal>& goal,
                   const std::function<bool()>& stop) {
  const auto stopped = [&stop] { return stop && stop(); };
  if (stopped() || too_large(count, works)) return std::nullopt;
  // Making one takes longer than most systems take to be solved.
  thread_local std::unique_ptr<z3::context> context;
  if (!context) context = std::make_unique<z3::context>();
  Times found;
  try {
    found = solved(*context, count, differences, works, goal, stop);
  } catch (const z3::exception&) {
    context.reset();
  }
  // One that was interrupted is not used again.
  if (!found && stopped()) context.reset();
  return found;
}

}  // namespace pal::analyzer
