// What would happen first if a halted operation went on, said before anything moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"

namespace pal::server {

/// A place from which an operation may go on.
struct Choice {
  enum class Where { here, before, start, other };
  std::string icon;
  Where where = Where::other;
  const char* method = "operation.from";            // how
  bool repeats = false;                             // a step that had begun begins again
  std::string skill{};                              // the first one; empty: none, or not known
  std::vector<operations::Parameter> parameters{};  // of that skill
  std::vector<std::string> preconditions{};
  bool forgets = false;  // counts and figures
  std::string text{};    // the same in words
};

struct Outlook {
  operations::ExecutionState state = operations::ExecutionState::ready;
  std::string token, reason;
  std::vector<Choice> choices;
};

/// A parameter of a skill's icon, as it would run next.
struct IconValue {
  std::string name;
  std::optional<operations::Value> value{};  // nothing: it is not known yet
  bool set = false;                          // else it is the default
  operations::Source source{};
  std::optional<std::pair<double, double>> limits{};  // what an operator may set
};

struct IconValues {
  std::string icon, skill;
  std::vector<IconValue> values;
};

/// The operation is at rest. `before`: the icon of the step before the token; empty: none. `cut_off`: the
/// step at the token had begun. `asked`: the place to look at; empty: the sensible ones. Throws
/// operations::ExecutionError.
Outlook outlook_of(const operations::Executor& executor, const operations::Skills& skills,
                   const std::string& before, bool cut_off, const std::string& asked);

/// Throws operations::ExecutionError.
IconValues values_of(const operations::Executor& executor, const operations::Skills& skills,
                     const std::string& icon);

}  // namespace pal::server
