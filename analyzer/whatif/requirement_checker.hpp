// A skill's requirements asked again and again, with other figures.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "analyzer/whatif/decide.hpp"
#include "analyzer/whatif/refutations.hpp"
#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::analyzer::whatif {

/// What a set of requirements comes to: `holds` if all do, `fails` if one does, else `undecided`.
struct Ruling {
  Verdict::State state = Verdict::State::undecided;
  RequirementId requirement;  // that fails, or is undecided
  /// Where all are loads: the greatest excess (Decision), if it is known of each.
  std::optional<Nanoseconds> excess = {};
};

/// What may be spent on one question.
struct Effort {
  /// The number of classes explored for each requirement that is open after bounds and a few runs; 0: none.
  std::size_t classes = 0;
  std::function<bool()> stop;  // asked now and then; what is open when it says true is undecided

  bool over() const { return stop && stop(); }
};

/// Decides whether requirements hold with other figures. It keeps the runs that refuted something: one that
/// still breaks its requirement with the new figures spares the exploration. What decides quickly is asked of
/// all requirements first: bounds, single runs, some classes, slices, all classes. The requirement that
/// failed last is asked first, and the first that fails ends the asking.
class RequirementChecker {
 public:
  RequirementChecker(const pan::Network& network, const Options& options)
      : network_(network),
        options_(options),
        workers_(options.threads),
        refutations_(std::make_shared<Refutations>()) {}

  /// One to ask at the same time as `other`, with so many `threads`. Both know what either finds.
  RequirementChecker(const RequirementChecker& other, unsigned threads)
      : network_(other.network_),
        options_(other.options_),
        workers_(threads),
        refutations_(other.refutations_) {
    options_.threads = threads;
  }

  /// Nothing: the environment is no model (a time is too long, …).
  std::optional<Problem> problem(const pan::Environment& environment) const;

  Ruling ask(const Problem& problem, const RequirementIds& requirements, const Effort& effort);
  /// With all that the options allow.
  Ruling ask(const Problem& problem, const RequirementIds& requirements);

  /// Whether bounds alone show that all of them hold: cheap, also where nothing can be explored.
  bool bounded(const Problem& problem, const RequirementIds& requirements) const;

  /// Whether some run gets to where no time passes any more. Nothing holds then.
  bool has_zeno_run(const Problem& problem);

  /// Whether a known run refutes it without exploration: the requirement; invalid: none is refuted.
  RequirementId refuted(const Problem& problem, const RequirementIds& requirements,
                        const std::function<bool()>& stop);

  const pan::Network& network() const { return network_; }
  bool stopped() const { return options_.stop && options_.stop(); }
  const Options& options() const { return options_; }

 private:
  /// A question on its way: what each requirement came to by now, in the order of asking.
  struct Progress;

  Ruling ruling_of(const Problem& problem, Progress progress, const Effort& effort);

  const pan::Network& network_;
  Options options_;
  Workers workers_;
  std::shared_ptr<Refutations> refutations_;
};

/// All of a problem.
RequirementIds requirements_of(const Problem& problem);

}  // namespace pal::analyzer::whatif
