// Work in several processes of this machine: each takes the next piece as soon as it has done one.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pal::study {

/// How a process ended that should not have: "by signal 9 (Killed)".
using Deaths = std::vector<std::string>;

struct CoresWork {
  std::size_t pieces = 0;
  unsigned processes = 1;
  /// Does a piece, in a process of its own. What it leaves must be outside the process: in files.
  std::function<void(std::size_t)> work;
  /// Called a few times a second in this process, with the number of pieces done.
  std::function<void(std::size_t)> progress = {};
  /// Once it is true, here or in a process, no piece is begun. The processes get SIGTERM.
  std::function<bool()> stop = {};
};

/// Returns when all processes have ended. A piece that a process died of is not done; the others do the rest.
/// The caller must have no other threads. Throws std::system_error if no process can be made.
Deaths run_on_cores(const CoresWork& work);

}  // namespace pal::study
