#include "programs/workcell/session/interrupt.hpp"

#include <signal.h>

#include <atomic>

namespace pal::workcell {
namespace {

// A signal handler can reach nothing else.
std::atomic<runtime::RunControl*> asked = nullptr;
static_assert(std::atomic<runtime::RunControl*>::is_always_lock_free);

void ask(int) {
  if (runtime::RunControl* control = asked.load()) control->stop();
}

void set_handler(void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);  // as nohup wants it
  }
}

}  // namespace

Interrupt::Interrupt(runtime::RunControl& control) {
  asked = &control;
  set_handler(ask, static_cast<int>(SA_RESETHAND | SA_RESTART));
}

Interrupt::~Interrupt() {
  set_handler(SIG_DFL, 0);
  asked = nullptr;
}

}  // namespace pal::workcell
