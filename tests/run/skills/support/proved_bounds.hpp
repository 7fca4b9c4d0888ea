// What is proved of a skill, and the worst that its runs came to.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "pal/trace/trace.hpp"
#include "programs/pal/session/proof.hpp"
#include "tests/run/skills/support/alter_cycles.hpp"
#include "tests/run/skills/support/slower.hpp"

namespace pal::test {

/// A part of the skill's PAL that is written in another way.
struct Rewritten {
  std::string from;
  std::string to;
};

class ProvedBounds {
 public:
  /// Proves the skill in its workcell, or in one that is slower. Throws std::runtime_error if its PAL is
  /// wrong. That a requirement fails is often found in the first of `most_states`, a bound is not.
  explicit ProvedBounds(const std::string& skill, const std::optional<Slower>& slower = std::nullopt,
                        std::size_t most_states = program::ProofLimits{}.max_states);

  /// Proves the skill with its PAL rewritten. Throws std::runtime_error if `from` is not in it.
  ProvedBounds(const std::string& skill, const Rewritten& rewritten);

  /// Measures the skill's requirements in a run of it.
  void observe(const trace::Trace& run);

  struct Worst {
    Duration bound{};
    Duration observed{};
    double part() const { return static_cast<double>(observed.count()) / static_cast<double>(bound.count()); }
  };
  /// Ages and responses, by requirement.
  const std::map<std::string, Worst>& worst() const { return worst_; }
  /// The greatest part of its bound that a requirement came to; 0 if none was measured.
  double greatest_part() const;
  /// Of all runs that were observed.
  const AlterCycles& alter() const { return alter_; }
  bool all_hold() const;
  /// Whether the requirement of this name fails; one that is undecided does not.
  bool fails(const std::string& requirement) const;

 private:
  program::Proof proof_;
  std::map<std::string, Worst> worst_;
  AlterCycles alter_;
};

}  // namespace pal::test
