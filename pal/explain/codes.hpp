// Codes as people write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic_code.hpp"

namespace pal::explain {

/// The code that is meant by "PAL0123", "pal0123", "0123" or "123".
std::optional<Code> find_code(std::string_view text);

/// Suggestions for a text that is not a code. For a number: its neighbours. Else the codes with the text in
/// their title. Else the codes of which the text is a misspelling.
std::vector<Code> codes_near(std::string_view text);

/// All rows of the table.
std::vector<Code> all_codes();

}  // namespace pal::explain
