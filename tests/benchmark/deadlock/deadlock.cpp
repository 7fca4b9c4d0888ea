// How long the search for deadlocks takes on skills of twelve modules and eight conditions.
//
// usage: bench_deadlock [RUNS [NAME]]: the median processor time of RUNS runs (5) of each skill, or of
// one; exit status 1 if one was not decided.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "pal/check/check.hpp"
#include "pal/check/deadlock/explore.hpp"
#include "pal/check/read_sources.hpp"
#include "tests/support/large_skill.hpp"

namespace {

struct Case {
  const char* name;
  pal::test::Shape shape;
  bool flaw;
};

using pal::test::Shape;
const std::vector<Case> cases = {
    {"star", Shape::star, false},
    {"concurrent", Shape::concurrent, false},
    {"chain", Shape::chain, false},
    {"couriers", Shape::couriers, false},
    {"polling", Shape::polling, false},
    {"nested", Shape::nested, false},
    {"star, wrong", Shape::star, true},
    {"concurrent, wrong", Shape::concurrent, true},
    {"chain, wrong", Shape::chain, true},
    {"couriers, wrong", Shape::couriers, true},
    {"polling, wrong", Shape::polling, true},
    {"nested, wrong", Shape::nested, true},
};

bool measure(const Case& one, int runs) {
  pal::MemoryFileSystem files;
  files.add("skill.pal", pal::test::LargeSkill(one.shape, one.flaw).text());
  pal::SourceManager sources;
  pal::Diagnostics diagnostics;
  const auto trees = pal::check::read_sources(files, sources, {"skill.pal"}, diagnostics);
  pal::Diagnostics findings;
  const auto specification = pal::check::check(trees, findings);
  const auto& network = specification.skills.front();
  const pal::pan::Flow flow(network);
  std::vector<double> seconds;
  pal::check::deadlock::Findings found;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::clock();
    found = pal::check::deadlock::explore(pal::check::deadlock::automata(network, flow));
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(seconds.begin(), seconds.end());
  std::cout << std::left << std::setw(20) << one.name << std::right << std::setw(3) << network.modules.size()
            << " modules " << std::setw(2) << network.conditions.size() << " conditions " << std::setw(8)
            << found.states << " states " << std::fixed << std::setprecision(3) << std::setw(8)
            << seconds[seconds.size() / 2] << " s  "
            << (!found.complete ? "undecided"
                : found.total   ? "deadlock after " + std::to_string(found.total->run.size())
                : found.partial ? "waits for ever after " + std::to_string(found.partial->run.size())
                                : "no deadlock")
            << '\n';
  return found.complete;
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  bool all = true;
  for (const auto& one : cases) {
    if (argc <= 2 || std::string(argv[2]) == one.name) all = measure(one, runs) && all;
  }
  return all ? 0 : 1;
}
