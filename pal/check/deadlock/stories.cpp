#include "pal/check/deadlock/stories.hpp"

namespace pal::check::deadlock {

std::vector<Story> stories(const pan::Network& network) {
  std::vector<Story> result;
  if (!network.main.valid()) return result;
  const pan::Flow flow(network);
  const auto automata = deadlock::automata(network, flow);
  const auto findings = explore(automata);
  for (const auto& end : {findings.total, findings.partial}) {
    if (end) result.push_back(tell(network, automata, *end));
  }
  for (const auto& undelivered : findings.undelivered) result.push_back(tell(network, automata, undelivered));
  return result;
}

}  // namespace pal::check::deadlock
