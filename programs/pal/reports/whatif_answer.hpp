// What `pal whatif` answers, and its two forms.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/whatif/placement.hpp"
#include "analyzer/whatif/remedy.hpp"
#include "analyzer/whatif/slack.hpp"
#include "programs/pal/session/program_changes.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// The answer for one skill in one environment; only what was asked for is there.
struct WhatIfAnswer {
  std::string skill;
  std::string environment;
  std::vector<std::string> requirements;
  std::vector<analyzer::whatif::Slack> slacks;
  bool slacks_shown = false;                           // while they were found: text() leaves them out
  std::optional<analyzer::whatif::Remedies> remedies;  // of what does not hold as things are
  std::vector<ProgramChange> program_changes;          // by ProgramChangeId: those that remedies speak of
  std::vector<Proof> before_and_after;                 // both, or neither
  std::vector<analyzer::whatif::Placements> placements;
  std::vector<std::string> witnesses;  // of refuted placements, if asked for: as they are filed
  bool fewest = false;                 // the placements answer how few processors do
  bool priorities = false;             // … in every order by priority
};

std::string text(const WhatIfAnswer& answer);

/// The table of slacks, line by line, for the terminal while they are found.
class SlackTable {
 public:
  /// `figures`: their names, which determine the width of the table.
  explicit SlackTable(const std::vector<std::string>& figures);
  std::string heading() const;
  std::string row(const WhatIfAnswer& answer, const analyzer::whatif::Slack& slack) const;

 private:
  std::size_t width_ = 12;
};

/// The changes that mend the requirements that do not hold; empty: none were looked for.
std::string remedies_text(const WhatIfAnswer& answer);
/// {"what_if": [{skill, environment, slack, remedies, changed, placements}]} (docs/reference/what-if.md).
std::string json(const std::vector<WhatIfAnswer>& answers);

/// Whether all that was asked for is met. If slack was asked for: everything holds as it is. Otherwise: all
/// hold after the change, and a placement is found.
bool good(const WhatIfAnswer& answer);

}  // namespace pal::program
