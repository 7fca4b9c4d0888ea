// A skill's requirements asked again and again, with other figures.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/whatif/decide.hpp"
#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::analyzer {

/// What a set of requirements comes to: `holds` if all do, `fails` if one does, else `undecided`.
struct Ruling {
  Verdict::State state = Verdict::State::undecided;
  int requirement = -1;  // that fails, or is undecided
  /// Where all are loads: the greatest excess (Decision), if it is known of each.
  std::optional<Nanoseconds> excess = {};
};

/// Keeps the runs that refuted something: one that still breaks its requirement with the new figures spares
/// the exploration. The requirement that failed last is asked first, and the first that fails ends the
/// asking.
class Judge {
 public:
  Judge(const pan::Network& network, const Options& options)
      : network_(network), options_(options), workers_(options.threads) {}

  /// Nothing: the environment is no model (a time is too long, …).
  std::optional<Problem> problem(const pan::Environment& environment) const;

  /// Of the requirements given, by index.
  Ruling ask(const Problem& problem, const std::vector<std::size_t>& requirements);

  /// Whether bounds alone show that all of them hold: cheap, also where nothing can be explored.
  bool bounded(const Problem& problem, const std::vector<std::size_t>& requirements) const;

  /// Whether some run gets to where no time passes any more. Nothing holds then.
  bool has_zeno_run(const Problem& problem);

  /// Whether a known run refutes it without exploration: the requirement, or -1.
  int refuted(const Problem& problem, const std::vector<std::size_t>& requirements);

  const pan::Network& network() const { return network_; }
  bool stopped() const { return options_.stop && options_.stop(); }
  const Options& options() const { return options_; }

 private:
  struct Refutation {
    std::size_t requirement;
    Witness witness;
  };

  const pan::Network& network_;
  Options options_;
  Workers workers_;
  std::vector<Refutation> refutations_;  // the last ones first
  std::vector<std::size_t> failed_;      // requirements, the last first
};

}  // namespace pal::analyzer
