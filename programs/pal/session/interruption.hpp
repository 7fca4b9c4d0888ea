// Ctrl-C: the first one ends what is being proved as undecided, the second one ends the program.
#pragma once

namespace pal::program {

/// While this object lives, the first SIGINT or SIGTERM only sets a flag. The next one ends the program as if
/// there were no handler. Within the life of another Interruption it changes nothing. For one thread only.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// May be called by any thread.
  static bool asked_for();
};

}  // namespace pal::program
