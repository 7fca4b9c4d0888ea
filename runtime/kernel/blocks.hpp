// CONCURRENT: starting, ending and cancelling blocks (docs/reference/execution-model.md, Messages, last
// paragraph).
#pragma once

#include <deque>

#include "pal/runtime/thread.hpp"
#include "runtime/kernel/flow.hpp"
#include "runtime/kernel/mail.hpp"

namespace pal::runtime {

class Blocks {
 public:
  Blocks(Executive& executive, Journal& journal, Flow& flow, Mail& mail, std::deque<Thread>& threads)
      : executive_(executive), journal_(journal), flow_(flow), mail_(mail), threads_(threads) {}

  void start(ConcurrentOperation& concurrent);

  /// The thread's body has come to its end.
  void ended(Thread& thread);

  /// Stops a cancelled thread that is between two statements, or waits.
  void stop(Thread& thread);

 private:
  void child_ended(Thread& parent);
  void cancel(Thread& thread);
  Thread& thread(int index) { return threads_[static_cast<std::size_t>(index)]; }

  Executive& executive_;
  Journal& journal_;
  Flow& flow_;
  Mail& mail_;
  std::deque<Thread>& threads_;
};

}  // namespace pal::runtime
