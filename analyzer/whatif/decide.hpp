// Whether a requirement holds, and no more: cheaper than its bound.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "analyzer/deciding.hpp"
#include "analyzer/exact/exact.hpp"
#include "analyzer/whatif/ids.hpp"
#include "analyzer/zones/workers.hpp"

namespace pal::analyzer::whatif {

/// `holds` (also where no run measures anything) and `fails` are proved as by analyze(). Runs in which time
/// stands still (zeno_run.hpp) are left to the caller.
struct Decision {
  Verdict::State state = Verdict::State::undecided;
  std::optional<Witness> witness;  // fails; nothing if no single run is known, or of loads
  /// Load: the distance to the limit, in nanoseconds of work in a second. It is that of a load that no run
  /// exceeds (holds), or that a run attains (fails). Nothing: not known.
  std::optional<Nanoseconds> excess;
  bool grows = false;  // it fails by what has only grown by the end of the run
};

/// A requirement of a question.
struct AskedCase {
  const Problem& problem;
  RequirementId requirement;
  const Verdict& bound;  // its compositional one
  Workers& workers;
  Decision& decision;     // what it has come to by now
  std::size_t& explored;  // classes

  bool is_open() const { return decision.state == Verdict::State::undecided; }
};
using AskingMethod = MethodFor<AskedCase>;

/// Methods that are tried of one requirement after the other, before the next round of any.
struct AskingRound {
  std::span<const AskingMethod> methods;
  std::size_t from;  // this number of allowed classes on
};

/// In the order in which they are tried. What decides quickly is asked of all requirements first.
std::span<const AskingRound> asking_rounds();

/// Whether a run that fires as `script` does, at times of its own, breaks the requirement; `script` may come
/// from a problem with other figures. False says nothing, also where `stop` ended it.
bool refutes(const Problem& problem, RequirementId requirement, const Witness& witness,
             const std::function<bool()>& stop);

}  // namespace pal::analyzer::whatif
