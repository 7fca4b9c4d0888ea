// Exact analysis: every requirement against every run.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

struct Analysis;

struct Options {
  /// Classes (age, response) or states (load) that one requirement may take; beyond that it is undecided.
  std::size_t max_states = 1'000'000;
  /// Threads that work on one requirement after the other; 0: one for each core. The result is the same for
  /// any number.
  unsigned threads = 0;
  /// Whether to find what adds up to compositional bounds (Verdict::addends).
  bool addends = true;
  /// Called now and then, by one thread at a time. Once it returns true, what is not decided stays undecided.
  std::function<bool()> stop;
  /// Seconds since some instant. For the statistics, which say 0 without it, and for sharing the time that is
  /// left until `deadline`.
  std::function<double()> clock;
  std::optional<double> deadline = {};  // by the clock: from then on `stop` says true
  /// Only whether each requirement holds is asked: a bound that suffices is as good as one that a run
  /// attains.
  bool verdicts_only = false;
  /// Called now and then by what chooses between analyses, with what is known of all requirements by now.
  std::function<void(const Analysis&)> known = {};
  /// For the statistics: the most memory that the program took since it was last asked, in bytes.
  std::function<std::size_t()> peak_memory;
};

/// A run that goes round these statements for ever at one instant (in Problem::statements, in the order of
/// the text). Then nothing is claimed about times.
struct ZenoRun {
  std::vector<StatementId> statements;
};

struct Analysis {
  std::vector<Verdict> verdicts;  // in the order of Problem::requirements
  Statistics statistics;          // sums; the greatest peak
  std::optional<ZenoRun> zeno_run = {};
  /// Devices that were proved to lose no event, by the compositional analysis; empty: it proved none.
  Table<DeviceId, bool> never_lost = {};
  /// While the analysis goes on (Options::known): what holds has a bound that suffices, but it is not known
  /// yet whether time stands still in some run, or whether anything is measured at all.
  bool bounds_only = false;
};

/// Whether every run ends. Then a load, which is that of the long run, has no meaning. False also where
/// `options` ended the exploration.
bool every_run_ends(const Problem& problem, const Options& options);

Analysis analyze_exactly(const Problem& problem, const Options& options = {});

}  // namespace pal::analyzer
