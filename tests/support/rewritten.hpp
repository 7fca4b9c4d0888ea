// Texts that say the same as others.
#pragma once

#include <random>
#include <string>

namespace pal::test {

/// Writes a skill in another way, at random. Its parts and the lines of its environment get another order.
/// Modules get other names. The first round of a loop is written before the loop. No measure changes. The
/// parts of a text are seen from its lines. If a text has an unusual layout, the result may have no meaning.
std::string rewritten(const std::string& text, std::mt19937_64& engine);

}  // namespace pal::test
