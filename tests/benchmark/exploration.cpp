// Exploration of zone graphs by one thread and by several, side by side.
//
// usage: benchmark_exploration [threads [rounds]]     a line a case: classes, median seconds of each, their
// ratio
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "analyzer/zones/zone_graph.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double seconds(const Machine& machine, unsigned threads, std::size_t& classes) {
  Workers workers(threads);
  Limits limits;
  limits.classes = 1'000'000;
  limits.workers = &workers;
  ZoneGraph graph(machine, 400'000'000, false);
  const auto begin = std::chrono::steady_clock::now();
  graph.explore(limits);
  classes = graph.classes().size();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int count, char** arguments) {
  const auto threads = static_cast<unsigned>(count > 1 ? std::atoi(arguments[1]) : 2);
  const int rounds = count > 2 ? std::atoi(arguments[2]) : 5;
  std::cout << std::fixed << std::setprecision(2);
  // Of the skills that the property tests draw these have more than 500,000 classes; they are followed up to
  // a million, as by `pal check`.
  for (const std::uint64_t seed : {8U, 20U, 22U, 25U}) {
    const auto skill = test::skill_from_text(test::RandomSkill(seed, 10).text());
    if (!skill->problem) continue;
    const Watch watch = watch_of(*skill->problem, skill->problem->requirements.front());
    const Machine machine(*skill->problem, watch);
    std::vector<double> alone;
    std::vector<double> shared;
    std::size_t classes = 0;
    for (int round = 0; round < rounds; ++round) {
      alone.push_back(seconds(machine, 1, classes));
      shared.push_back(seconds(machine, threads, classes));
    }
    std::cout << "seed " << seed << ": " << classes << " classes, 1 thread " << median(alone) << " s, "
              << threads << " threads " << median(shared) << " s, ratio " << median(alone) / median(shared)
              << "\n";
  }
}
