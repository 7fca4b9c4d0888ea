#include "pal/driver/interruption.hpp"

#include <csignal>

namespace pal::driver {
namespace {

// A signal's handler can reach nothing else.
volatile std::sig_atomic_t interrupted = 0;

void mark(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  interrupted = 0;
  std::signal(SIGINT, mark);
  std::signal(SIGTERM, mark);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::asked_for() {
  return interrupted != 0;
}

}  // namespace pal::driver
