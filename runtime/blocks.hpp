// CONCURRENT: starting, ending and cancelling blocks (docs/reference/execution-model.md, Messages, last
// paragraph).
#pragma once

#include "runtime/thread.hpp"

namespace pal::runtime {

class Blocks {
 public:
  explicit Blocks(Run& run) : run_(run) {}

  void start(ConcurrentOperation& concurrent);

  /// The thread's body has come to its end.
  void ended(Thread& thread);

  /// Stops a cancelled thread that is between two statements, or waits.
  void stop(Thread& thread);

 private:
  void child_ended(Thread& parent);
  void cancel(Thread& thread);

  Run& run_;
};

}  // namespace pal::runtime
