// Ctrl-C: the first time what is being proved ends as undecided, the second time the program does.
#pragma once

namespace pal::driver {

/// While it lives, the first SIGINT or SIGTERM only sets a mark; the next one ends the program as if nobody
/// had listened. Within the life of another one it changes nothing. By one thread only.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// May be asked by any thread.
  static bool asked_for();
};

}  // namespace pal::driver
