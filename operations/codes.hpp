// Where the token goes with a completion code.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "operations/check.hpp"
#include "operations/model.hpp"

namespace pal::operations {

/// Whether the icon ends with a code: a skill, a hierarchical icon, a wait or a test.
bool has_completions(IconKind kind);

/// The output by which the token leaves a skill or a hierarchical icon that ended with `code`. `normal`: the
/// skill's completion is a normal one; for a hierarchical icon, the code is 0. It is the first of these that
/// fits:
///
/// 1. the way of a CASE behind `next` (behind MERGEs and delays, too) that names the code;
/// 2. `error`, unless the code is normal;
/// 3. the default of the CASE;
/// 4. `next`, if the code is normal;
/// 5. `error`.
///
/// Nothing: no icon handles the code.
std::optional<Connection> route(const Operation& operation, const Icon& icon, int code, bool normal);

/// The output of a CASE for a code; nothing if it has neither a way nor a default for it.
std::optional<Connection> way_of(const Icon& branch, int code);

/// The CASE that the token comes to by this connection, passing MERGEs and delays only; nothing if none.
std::optional<std::size_t> case_behind(const Operation& operation, const Connection& connection);

/// The codes that can be the last ones at each icon.
struct PossibleCodes {
  std::vector<std::vector<std::set<int>>> at;  // by operation and icon: on arrival
  std::vector<std::set<int>> exits;            // by operation: with what it ends
};

/// A skill that is not known ends with 0. The program has no errors of shape.
PossibleCodes possible_codes(const Program& program, const Skills& skills);

/// All completions of what has_completions(): code, and whether it is normal. All codes of a test are normal
/// but `sensor_failed`; of a wait 0 is.
std::vector<std::pair<int, bool>> completions_of(const Program& program, const Operation& operation,
                                                 const Icon& icon, const Skills& skills,
                                                 const std::vector<std::set<int>>& exits);

}  // namespace pal::operations
