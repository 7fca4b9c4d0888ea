// One icon of a file of operations.
#pragma once

#include <optional>
#include <string>

#include "operations/json_value.hpp"
#include "operations/model.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::operations {

/// Reads an icon, and reports wrong fields of it (PAL1002). Nothing if it is none, or of no kind that there
/// is. `id` gets its id all the same.
std::optional<Icon> read_icon(const JsonValue& value, std::string& id, Diagnostics& diagnostics);

}  // namespace pal::operations
