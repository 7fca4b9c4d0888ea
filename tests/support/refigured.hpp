// The same skills in other workcells, asked everything.
#pragma once

#include <cstddef>
#include <random>
#include <string>

namespace pal::test {

/// A skill with other figures: times, costs, limits, periods, phases, latencies, places and priorities drawn
/// from so few that many are equal. Some of them, or all. The kind of a line is seen from its beginning. If a
/// text has an unusual layout, the result may have no meaning.
std::string refigured(const std::string& text, std::mt19937_64& engine);

/// A skill with up to `most` other requirements than its own: of each measure, at whatever statements,
/// events, messages, conditions and samples it has. Without a meaning, or one that can be asked, the text
/// itself.
std::string asked_everything(const std::string& text, std::mt19937_64& engine, std::size_t most);

}  // namespace pal::test
