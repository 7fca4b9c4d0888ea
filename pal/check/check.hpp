// From trees to networks: the checked form that every later stage starts from.
#pragma once

#include <functional>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal {

/// What a set of files says. If there were errors, a network may lack what the errors are about, but its ids
/// are good.
struct Specification {
  std::vector<pan::Network> skills;
  std::vector<pan::Environment> environments;
  /// Modules of files that no skill uses, a network for each such file: names that are not declared are taken
  /// on trust, those that are sent to or waited for as devices. To be drawn, not to be proved or run.
  std::vector<pan::Network> sketches;
};

/// Looks up every name (a file sees what it declares and what the files that it USES declare), builds the
/// networks, and reports everything that can be said without times. Each skill is checked with what its own
/// file sees. `stop` is asked again and again by what may take long, the search for deadlocks: true leaves it
/// undecided. Empty: it takes as long as it takes.
Specification check(const std::vector<syntax::Tree>& trees, Diagnostics& diagnostics,
                    const std::function<bool()>& stop = {});

}  // namespace pal
