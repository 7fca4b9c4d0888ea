#include "tests/run/skills/support/alter_cycles.hpp"

namespace pal::test {

void AlterCycles::count(const trace::Trace& run) {
  bool open = false;
  for (const trace::Event& event : run.events) {
    if (event.kind != trace::Kind::put && event.kind != trace::Kind::overrun) continue;
    const trace::Channel& channel = run.channels[static_cast<std::size_t>(event.subject)];
    if (channel.sender == "alter" && channel.message == "tick") {
      ++asked;
      if (open || event.kind == trace::Kind::overrun) ++missed;
      open = true;
    }
    if (channel.receiver == "alter" && channel.message == "correction") open = false;
  }
}

}  // namespace pal::test
