#include "tests/run/support/written_skill.hpp"

#include <algorithm>
#include <sstream>

namespace pal::test {

std::string to_text(const trace::Trace& trace) {
  std::ostringstream out;
  const auto at = [](const auto& table, int index) { return table[static_cast<std::size_t>(index)]; };
  for (const trace::Event& event : trace.events) {
    out << static_cast<double>(event.time_ns) / 1e6 << ' ' << trace::name(event.kind);
    if (event.actor >= 0) out << ' ' << at(trace.actors, event.actor).name;
    if (event.statement >= 0) out << ' ' << at(trace.statements, event.statement).text;
    switch (event.kind) {
      case trace::Kind::put:
      case trace::Kind::take:
      case trace::Kind::drop:
      case trace::Kind::overrun:
      case trace::Kind::give_up:
        out << " <" << at(trace.channels, event.subject).message << '>';
        break;
      case trace::Kind::set:
      case trace::Kind::read:
        out << ' ' << at(trace.conditions, event.subject) << '=' << event.value;
        break;
      case trace::Kind::complete:
        out << ' ' << event.value;
        break;
      case trace::Kind::broken:
        out << ": " << at(trace.promises, event.value);
        break;
      case trace::Kind::fault:
        out << ' ' << at(trace.faults, event.value);
        break;
      default:
        break;
    }
    out << '\n';
  }
  return out.str();
}

std::string only(const std::string& text, const std::vector<std::string>& words) {
  std::istringstream in(text);
  std::string result;
  for (std::string line; std::getline(in, line);) {
    const bool wanted = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return line.find(word) != std::string::npos;
    });
    if (wanted) result += line + "\n";
  }
  return result;
}

}  // namespace pal::test
