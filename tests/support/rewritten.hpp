// Texts that say the same as others.
#pragma once

#include <random>
#include <string>

namespace pal::test {

/// Writes a skill in another way, by chance: what it consists of and the lines of its environment in another
/// order, other names for modules, the first round of a loop before it. No measure changes. What the parts of
/// a text are is seen by its lines; of one that is out of the ordinary the result may have no meaning.
std::string rewritten(const std::string& text, std::mt19937_64& engine);

}  // namespace pal::test
