#include "analyzer/runs/linear_times.hpp"

#include <z3++.h>

namespace pal::analyzer {
namespace {

/// Harder ones than this are given up: the bound is then only not called exact.
constexpr unsigned most_milliseconds = 2000;

z3::expr number(z3::context& context, Nanoseconds value) {
  return context.int_val(static_cast<std::int64_t>(value));
}

}  // namespace

std::optional<std::vector<Nanoseconds>> linear_times(std::size_t count,
                                                     const std::vector<Difference>& differences,
                                                     const std::vector<Work>& works,
                                                     const std::optional<Goal>& goal) {
  try {
    // Making one takes longer than most systems take to be solved.
    thread_local z3::context context;
    z3::optimize solver(context);
    z3::params parameters(context);
    parameters.set("timeout", most_milliseconds);
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
      z3::expr sum = number(context, 0);
      for (const auto& [begin, end] : work.pieces) sum = sum + times[end] - times[begin];
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
    if (solver.check() != z3::sat) return std::nullopt;
    const z3::model model = solver.get_model();
    std::vector<Nanoseconds> found;
    for (const z3::expr& time : times) {
      std::int64_t value = 0;
      if (!model.eval(time, true).is_numeral_i64(value)) return std::nullopt;
      found.push_back(value);
    }
    return found;
  } catch (const z3::exception&) {
    return std::nullopt;
  }
}

}  // namespace pal::analyzer
