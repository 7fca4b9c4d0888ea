// Exact analysis: every requirement against every run.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

struct Options {
  /// Classes (age, response) or states (load) that one requirement may take; beyond that it is undecided.
  std::size_t max_states = 1'000'000;
  /// At work on one requirement after the other; 0: as many as the machine has cores. Says nothing about the
  /// result, which is the same for any number.
  unsigned threads = 0;
  /// Whether to find what adds up to compositional bounds (Verdict::addends).
  bool addends = true;
  /// Asked now and then, by one thread at a time; once it says true, what is not decided stays undecided.
  std::function<bool()> stop;
  /// Seconds from some beginning: for the statistics, which say 0 without it, and for the shares of what is
  /// left until `deadline`.
  std::function<double()> clock;
  std::optional<double> deadline = {};  // by the clock: from then on `stop` says true
  /// For the statistics: the most memory that the program took since it was last asked, in bytes.
  std::function<std::size_t()> peak_memory;
};

/// Some run goes round these statements for ever at one instant (in Problem::statements, in the order of the
/// text). Then nothing is said of times.
struct ZenoRun {
  std::vector<int> statements;
};

struct Analysis {
  std::vector<Verdict> verdicts;  // in the order of Problem::requirements
  Statistics statistics;          // sums; the greatest peak
  std::optional<ZenoRun> zeno_run = {};
};

/// Whether every run ends: then a load, which is that of the long run, says nothing. False says nothing, as
/// where `options` ended the exploration.
bool every_run_ends(const Problem& problem, const Options& options);

Analysis analyze_exactly(const Problem& problem, const Options& options = {});

}  // namespace pal::analyzer
