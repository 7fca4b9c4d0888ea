// The language server: messages in, messages out, proofs on a thread of their own.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "language_server/proofs.hpp"
#include "pal/support/file_system.hpp"

namespace pal::language_server {

struct Options {
  std::string version;             // of the program
  std::string documentation;       // URL of the folder docs; empty: findings get no links
  const Prover* prover = nullptr;  // none: nothing is proved
  double repair_seconds = 0.5;     // one who asks for quick fixes waits so long for those that must be tried
  /// Called when a thread has done what a text asked for, perhaps by several at once. Empty: nothing is.
  std::function<void()> at_rest = {};
};

/// Serves one client until it says `exit` or `in` ends. One thread reads, one answers, one proves. A message
/// that changes a text ends the proofs at once. `log` gets a line a message; nullptr: nothing does. True:
/// the client had shut the server down before.
bool serve(std::istream& in, std::ostream& out, const FileSystem& files, const Options& options,
           std::ostream* log = nullptr);

/// The same for tests, on one thread. Each line of `script` is a message; after each one all checks and
/// proofs are made. What is sent is written to the result, a message a line, keys sorted.
std::string replay(const std::string& script, const FileSystem& files, const Options& options);

}  // namespace pal::language_server
