// What a skill declares to its cell, in a file beside its PAL: its longest times, and its limits in charts.
// docs/workcell/declared.md has the form of the text.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "operations/formula.hpp"
#include "pal/pan/network.hpp"

namespace pal::operations {

/// `factor` times the value of a parameter.
struct Share {
  std::string parameter;
  double factor = 1;
};

/// A line that people see over fields of a channel while the skill runs: at `at`, and with `both` at the
/// negative of that. It counts from `around`, if given.
struct DeclaredLimit {
  enum class Kind { band, target, stop, error };
  int line = 0;  // of the text
  std::vector<std::string> fields;
  std::string channel;
  Kind kind = Kind::target;
  bool both = false;
  Share at;
  std::optional<Share> around{};
};

struct DeclaredTime {
  int line = 0;     // of the text
  Formula seconds;  // of the parameters, each a number in its unit; TRUE is 1
};

/// Nobody has proved it.
struct Declared {
  std::map<int, DeclaredTime> longest{};  // by completion code
  std::vector<DeclaredLimit> limits{};
};

struct DeclaredError {
  int line = 0;
  std::string cause;
};

std::variant<Declared, DeclaredError> read_declared(std::string_view text);

/// The first thing that does not fit the skill: a code or a parameter that it does not have, or a parameter
/// that is no number. Also a time that has no bound when all parameters have their defaults.
std::optional<DeclaredError> misfit(const Declared& declared, const pan::Template& skill);

}  // namespace pal::operations
