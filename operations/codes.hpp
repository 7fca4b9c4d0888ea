// Where the token goes with a completion code.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "operations/check.hpp"
#include "operations/graph.hpp"
#include "operations/model.hpp"

namespace pal::operations {

/// Whether the icon ends with a code: a skill, a hierarchical icon, a wait, a test, a question or a zero.
bool has_completions(IconKind kind);
/// Whether the icon has the output `next`.
bool has_next(IconKind kind);

/// The output by which the token leaves an icon that has_completions() and ended with `code`. `normal`: the
/// skill's completion is a normal one; for a hierarchical icon, the code is 0. It is the first of these that
/// fits:
///
/// 1. the way of a CASE behind `next` (behind MERGEs and delays, too) that names the code;
/// 2. `error`, unless the code is normal;
/// 3. the default of the CASE;
/// 4. `next`, if the code is normal;
/// 5. `error`.
///
/// Nothing: no icon handles the code. A question is left by its answer, and else by `error`.
std::optional<Connection> route(const Graph& graph, Place at, int code, bool normal);

/// The output of a CASE for a code; nothing if it has neither a way nor a default for it.
std::optional<Connection> way_of(const Icon& branch, int code);
/// Whether one of the ways of a CASE names the code.
bool names_code(const Icon& branch, int code);

/// A set of completion codes of one program.
class CodeSet {
 public:
  /// `all`: every code that there is, in ascending order.
  explicit CodeSet(std::shared_ptr<const std::vector<int>> all);
  bool contains(int code) const;
  bool empty() const;
  std::vector<int> list() const;
  /// The answers say whether the set has grown.
  bool insert(int code);
  bool insert(const CodeSet& codes);

 private:
  std::shared_ptr<const std::vector<int>> all_;
  std::vector<std::uint64_t> bits_;
};

/// The codes that can be the last ones at each icon.
struct PossibleCodes {
  std::vector<std::vector<CodeSet>> at;  // by operation and icon: on arrival
  std::vector<CodeSet> exits;            // by operation: with what it ends
  bool complete = true;                  // false: it was stopped, and codes are missing
};

/// A skill that is not known ends with 0. The program has no errors of shape. `stop` is asked again and
/// again; true ends the search.
PossibleCodes possible_codes(const Graph& graph, const Skills& skills, const Stop& stop = {});

/// A way in which an icon ends: its code, and what that means.
struct Ending {
  int code = 0;
  pan::Completion::Kind kind = pan::Completion::Kind::normal;

  /// "code 3", "any other code".
  std::string text() const { return code == any_code ? "any other code" : "code " + code_text(code); }
  bool normal() const { return kind == pan::Completion::Kind::normal; }
};

/// All endings of what has_completions(). All codes of a test and of a question are normal but `no_value` and
/// `time_over`; of a wait, a zero and a sub-operation 0 is. `any_code`: a sub-operation ends with a count.
std::vector<Ending> endings_of(const Graph& graph, Place at, const Skills& skills,
                               const std::vector<CodeSet>& exits);

}  // namespace pal::operations
