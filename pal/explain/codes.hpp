// Codes as people write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic_code.hpp"

namespace pal {

/// The code that is meant by "PAL0123", "pal0123", "0123" or "123".
std::optional<Code> find_code(std::string_view text);

/// What to offer for a text that names no code: the neighbours of a number, else those whose title has the
/// text in it, else those whose name is a slip of the fingers away.
std::vector<Code> codes_near(std::string_view text);

/// All rows of the table.
std::vector<Code> all_codes();

}  // namespace pal
