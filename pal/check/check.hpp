// From trees to networks: the checked form that every later stage starts from.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// What a set of files says. After errors a network may lack the parts that the errors are about, but its ids
/// are valid.
struct Specification {
  std::vector<pan::Network> skills;
  std::vector<pan::Environment> environments;
  /// By file with a skill: the files that it sees, itself included.
  std::map<FileId, std::set<FileId>> seen;
  /// Modules of files that no skill uses, one network for each such file. Names that are not declared are
  /// trusted; unknown senders and receivers become devices. For drawing, not for proofs or runs.
  std::vector<pan::Network> sketches;
};

/// How much is checked.
enum class Depth { all, without_deadlocks };

/// Looks up every name, builds the networks, and reports everything that can be found without times. A file
/// sees its own declarations and those of the files that it USES; each skill is checked with what its own
/// file sees. `stop` is called again and again by checks that may take long, such as the search for
/// deadlocks. If it returns true, they end undecided. Empty: they take as long as they need.
/// Where a file has syntax errors, names alone are looked up, if all declarations could be read.
Specification check(const std::vector<syntax::Tree>& trees, Diagnostics& diagnostics,
                    const std::function<bool()>& stop = {}, Depth depth = Depth::all);

}  // namespace pal::check
