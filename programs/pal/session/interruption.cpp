#include "programs/pal/session/interruption.hpp"

#include <csignal>

namespace pal::program {
namespace {

// A signal's handler can reach nothing else.
volatile std::sig_atomic_t interrupted = 0;

int listening = 0;  // how many Interruptions there are

void mark(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  if (++listening > 1) return;
  interrupted = 0;
  std::signal(SIGINT, mark);
  std::signal(SIGTERM, mark);
}

Interruption::~Interruption() {
  if (--listening > 0) return;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::asked_for() {
  return interrupted != 0;
}

}  // namespace pal::program
