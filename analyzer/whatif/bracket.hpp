// The search for the greatest growth with which a set of requirements holds: what is known of it by now.
#pragma once

#include <optional>

#include "analyzer/whatif/requirement_checker.hpp"
#include "analyzer/whatif/scaling.hpp"

namespace pal::analyzer::whatif {

/// How near holding and failing have to come: to the nanosecond, or to some hundredths.
enum class Precision { rough, exact };

/// Holding and failing are monotone in the growth. Deciding is not, so what could not be decided is kept
/// apart from what was proved. Works in turns. Each turn goes on where the last one stopped.
class Bracket {
 public:
  /// `loads`: the requirements are loads. The scaling must live as long.
  Bracket(const Scaling& scaling, RequirementIds requirements, bool loads);

  /// The growth with which everything holds.
  Nanoseconds holds() const { return holds_; }
  /// The growth with which something fails. Nothing: not found.
  std::optional<Nanoseconds> fails() const { return fails_; }
  /// What fails there; else what could not be decided last.
  RequirementId requirement() const { return fails_ ? failing_ : open_; }
  const RequirementIds& requirements() const { return requirements_; }

  /// Known to hold, by bounds.
  void hold(Nanoseconds extra) { holds_ = std::max(holds_, extra); }

  /// Narrows, below `ceiling`, until holding and failing are as near to each other as is wanted, or until the
  /// effort is over. `ceiling` itself need not be asked. What this effort cannot decide is asked again by a
  /// greater one only.
  void narrow(RequirementChecker& checker, const Effort& effort, Precision precision, Nanoseconds ceiling);

  /// Nothing is left to be asked below `ceiling`, unless with more effort.
  bool exhausted(Nanoseconds ceiling) const;

 private:
  Nanoseconds tolerance(Precision precision) const;
  Nanoseconds upper_end(Nanoseconds ceiling) const;
  Nanoseconds lower_end(Nanoseconds ceiling) const;
  std::optional<Nanoseconds> next(Nanoseconds tolerance, Nanoseconds ceiling, bool explores);
  Nanoseconds step_up(Nanoseconds from, Nanoseconds ceiling);
  Nanoseconds middle(Nanoseconds low, Nanoseconds high) const;
  void hear(Nanoseconds extra, const Ruling& ruling);
  void look_for_failure(RequirementChecker& checker, const Effort& effort, Nanoseconds ceiling);
  void sharpen(RequirementChecker& checker, const Effort& effort);

  const Scaling& scaling_;
  const RequirementIds requirements_;
  const Nanoseconds longer_;  // by how much steps get longer
  Nanoseconds step_;
  Nanoseconds looked_up_to_ = 0;  // for a failure
  Nanoseconds holds_ = 0;
  std::optional<Nanoseconds> fails_;
  RequirementId failing_;
  RequirementId open_;
  /// The least and the greatest growth that the present effort could not decide.
  std::optional<std::pair<Nanoseconds, Nanoseconds>> undecided_;
  std::size_t classes_ = 0;             // of that effort
  std::optional<Nanoseconds> hurried_;  // the growth that the last turn had no time to decide
  bool again_ = true;                   // that was asked last, not less
  std::optional<Nanoseconds> below_;    // excess of loads with `holds_`, if it is known
  std::optional<Nanoseconds> above_;    // with lower_end()
  bool next_to_failure_ = true;
  int asked_ = 0;
};

}  // namespace pal::analyzer::whatif
