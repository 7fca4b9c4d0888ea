// What slices leave out, and what that saves.
//
// usage: benchmark_slices FILE...     the first skill of the files in their first environment; two lines a
// requirement: what is kept, and for each relaxation the classes, the seconds and the greatest value found
#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "analyzer/exact/cap.hpp"
#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/slice/slice.hpp"
#include "analyzer/zones/zone_graph.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

void explore(const Problem& problem, const Requirement& requirement, Nanoseconds cap, const char* name,
             ZoneGraph::Merging merging = ZoneGraph::Merging::within) {
  const Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  Workers workers(0);
  ZoneGraph graph(machine, cap, false, merging);
  const auto begin = std::chrono::steady_clock::now();
  const bool complete = graph.explore({400'000, {}, {}, &workers});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::cout << "  " << name << ": " << graph.classes().size() << (complete ? "" : "+") << " classes, "
            << graph.places().size() << " states, " << seconds.count() << " s, value "
            << static_cast<double>(graph.peak().value) / 1e6 << (graph.failure() ? ", failure" : "")
            << (graph.over_cap() ? ", over the cap" : "") << (graph.never_answered() ? ", grows" : "")
            << "\n";
}

}  // namespace

int main(int count, char** arguments) {
  const auto skill = pal::test::skill_from_files({arguments + 1, arguments + count});
  if (!skill->problem) {
    std::cerr << pal::test::messages(skill->diagnostics);
    return EXIT_FAILURE;
  }
  const Problem& problem = *skill->problem;
  std::cout << std::fixed << std::setprecision(2);
  for (const Requirement& requirement : problem.requirements) {
    const Cone cone = cone_of(problem, requirement);
    std::cout << requirement.name << ":";
    for (const ThreadId t : cone.threads.ids())
      if (cone.threads[t]) std::cout << " " << problem.threads[t].name;
    std::cout << " |";
    for (const DeviceId d : cone.devices.ids())
      if (cone.devices[d]) std::cout << " " << problem.devices[d].name;
    std::cout << "\n";
    const Nanoseconds cap = cap_of(problem, requirement.limit);
    explore(slice_of(problem, cone, {false, false}), requirement, cap, "slice");
    explore(slice_of(problem, cone, {true, false}), requirement, cap, "conditions");
    explore(slice_of(problem, cone, {true, true}), requirement, cap, "conditions, periods");
    explore(slice_of(problem, cone, {true, true}), requirement, cap, "the same, widened",
            ZoneGraph::Merging::hull);
    Options options;
    const auto begin = std::chrono::steady_clock::now();
    const SliceBound found = slice_bound(problem, requirement, options, 400'000);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::cout << "  as pal check does: " << found.statistics.classes << " classes, " << seconds.count()
              << " s, " << (found.bound ? static_cast<double>(*found.bound) / 1e6 : -1) << "\n";
  }
  return EXIT_SUCCESS;
}
