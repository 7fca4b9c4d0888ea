// Measures the compositional analysis: how near its bounds are to what runs show, and how its time grows.
//
//   benchmark_compositional systems [COUNT [FIRST_SEED [EXACT_SECONDS]]]     seconds of processor time a
//   system benchmark_compositional growth
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/runs/run_search.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/holistic.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::ChainShape;
using test::ChainSystem;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string milliseconds(std::optional<Nanoseconds> time) {
  if (!time) return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(3) << static_cast<double>(*time) / 1e6;
  return out.str();
}

/// The greatest response in the run that is looked for, and in 8 runs of 4 s each.
Nanoseconds greatest_shown(const Problem& problem, const Requirement& requirement, std::uint64_t seed,
                           bool& failed) {
  const Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  Nanoseconds greatest = -1;
  if (const auto found = search_runs(problem, requirement, {})) {
    failed = failed || found->failed;
    if (!found->failed) greatest = found->measured.value;
  }
  for (std::uint64_t run = 0; run < 8; ++run) {
    SimulationOptions options;
    options.times = run < 4 ? SimulationOptions::Times::worst : SimulationOptions::Times::extremes;
    options.seed = seed * 1000 + run;
    options.until = 4'000'000'000;
    options.max_events = 60'000;
    options.record = false;
    const Simulation made = simulate(machine, options);
    failed = failed || made.failed;
    for (const Measurement& measured : made.measured) greatest = std::max(greatest, measured.value);
  }
  return greatest;
}

/// By requirement, those that a run attains and that were proved in `seconds` of processor time for all of
/// the problem, which are shared evenly.
std::vector<std::optional<Nanoseconds>> exact_bounds(const Problem& problem, double seconds) {
  std::vector<std::optional<Nanoseconds>> bounds(problem.requirements.size());
  if (seconds <= 0) return bounds;
  const auto used_since = [](std::clock_t begin) {
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  const std::clock_t first = std::clock();
  for (std::size_t r = 0; r < bounds.size(); ++r) {
    const double left = seconds - used_since(first);
    const double share = left / static_cast<double>(bounds.size() - r);
    Problem alone = problem;
    alone.requirements = {problem.requirements[r]};
    Options options;
    options.max_states = 2'000'000;
    options.threads = 1;
    options.stop = [&used_since, share, begin = std::clock()] { return used_since(begin) > share; };
    const Verdict verdict = analyze_exactly(alone, options).verdicts.front();
    if (verdict.exact && verdict.bound) bounds[r] = verdict.bound->count();
  }
  return bounds;
}

void distribution(const std::string& of, std::vector<double> values) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
  };
  std::cout << of << ": " << values.size() << " values, least " << at(0) << ", 10 % " << at(0.1)
            << ", median " << at(0.5) << ", 90 % " << at(0.9) << ", greatest " << at(1) << "\n";
}

int systems(std::uint64_t count, std::uint64_t first, double exact_seconds) {
  std::cout << std::fixed << std::setprecision(3)
            << "seed chain processors chains load stages | compositional holistic exact shown (ms)\n";
  std::vector<double> to_shown;
  std::vector<double> to_holistic;
  std::vector<double> to_exact;
  std::size_t chains = 0;
  std::size_t bounds = 0;
  std::size_t only_holistic = 0;
  std::size_t losing = 0;
  std::size_t over = 0;
  double seconds = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    ChainSystem system;
    const ChainShape shape = test::benchmark_shape(seed);
    system = test::random_chains(seed, shape);
    const Problem problem = test::problem_of(system);
    const auto begin = Clock::now();
    const Analysis compositional = compositional::analyze(problem);
    seconds += seconds_since(begin);
    const auto baseline = test::holistic(system);
    const auto exact = exact_bounds(problem, exact_seconds);
    for (std::size_t c = 0; c < problem.requirements.size(); ++c) {
      ++chains;
      bool failed = false;
      const Nanoseconds shown = greatest_shown(problem, problem.requirements[c], seed * 10 + c, failed);
      losing += failed ? 1 : 0;
      std::optional<Nanoseconds> bound;
      if (compositional.verdicts[c].bound) bound = compositional.verdicts[c].bound->count();
      const std::optional<Nanoseconds> exactly = exact[c];
      std::cout << seed << " " << c + 1 << " " << shape.processors << " " << shape.chains << " " << shape.load
                << " " << system.chains[c].stages.size() << " | " << milliseconds(bound) << " "
                << milliseconds(baseline[c]) << " " << milliseconds(exactly) << " " << milliseconds(shown)
                << (failed ? " loses events" : "")
                << (bound ? "" : "  " + compositional.verdicts[c].explanation.text()) << "\n";
      if (!bound) {
        only_holistic += baseline[c] ? 1 : 0;
        continue;
      }
      ++bounds;
      const auto value = static_cast<double>(*bound);
      if (shown > 0) to_shown.push_back(value / static_cast<double>(shown));
      if (exactly) to_exact.push_back(value / static_cast<double>(*exactly));
      if (baseline[c]) {
        to_holistic.push_back(value / static_cast<double>(*baseline[c]));
        over += *bound > *baseline[c] ? 1 : 0;
      }
      if (failed || shown > *bound || (exactly && *exactly > *bound)) {
        std::cout << "THE BOUND IS WRONG\n";
        return 1;
      }
    }
  }
  std::cout << count << " systems, " << chains << " chains: " << bounds << " bounds in " << seconds << " s; "
            << losing << " chains were seen to lose events; " << only_holistic
            << " have a holistic bound alone (which knows no slots), " << over
            << " bounds are above the holistic one\n";
  distribution("bound / greatest shown", to_shown);
  distribution("bound / holistic", to_holistic);
  distribution("bound / exact", to_exact);
  return over == 0 ? 0 : 1;
}

/// Chains of four stages at 60 % load; `steps` activities.
void grow(int steps, int processors) {
  ChainShape shape;
  shape.processors = processors;
  shape.chains = steps / 4;
  shape.stages_least = shape.stages_most = 4;
  shape.load = 0.6;
  const Problem problem = test::problem_of(test::random_chains(7, shape));
  const auto begin = Clock::now();
  Options options;
  options.addends = false;  // as pal check without --explain
  const Analysis analysis = compositional::analyze(problem, options);
  const double seconds = seconds_since(begin);
  const auto bounds = std::count_if(analysis.verdicts.begin(), analysis.verdicts.end(),
                                    [](const Verdict& verdict) { return verdict.bound.has_value(); });
  std::cout << std::fixed << std::setprecision(3) << steps << " activities in " << problem.steps.size()
            << " statements on " << processors << " processors: " << seconds << " s, " << bounds << " of "
            << analysis.verdicts.size() << " bounds\n";
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "systems";
  if (mode == "growth") {
    for (int steps : {400, 800, 1600, 3200, 6400, 10000}) grow(steps, steps / 25);
    for (int steps : {400, 1600, 10000}) grow(steps, 16);
    return 0;
  }
  const auto number = [&](int at, const char* usual) { return std::string(argc > at ? argv[at] : usual); };
  return systems(std::stoull(number(2, "80")), std::stoull(number(3, "1")), std::stod(number(4, "0")));
}
