// For how long hand-written code holds a processor.
#pragma once

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// Measures one piece of code of the calling thread, from its making to held().
///
/// A statement of PAL keeps its processor while it sleeps or waits for something. So code that does so holds
/// its processor for as long as it takes by the wall. Code that does not holds it for its processor time, and
/// what other programs take meanwhile does not count. The system counts how often a thread gave its CPU away
/// by itself (getrusage, ru_nvcsw).
class HeldTime {
 public:
  HeldTime();
  /// How long the code has held its processor. `interrupted`: by the wall, while the processor was given to
  /// another thread of the skill.
  Time held(Time interrupted = Time::zero()) const { return blocked_ ? by_the_wall(interrupted) : worked_; }
  /// The code has come to its end. Once, before held().
  void end();

 private:
  Time by_the_wall(Time interrupted) const;

  long given_away_;
  Time begun_, worked_;
  Time taken_{};
  bool blocked_ = false;
};

/// What a HeldTime measures of nothing: the least of several.
Time cost_of_held_time();

}  // namespace pal::runtime
