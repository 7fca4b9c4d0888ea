// The pages as the build embeds them.
#pragma once

#include <span>
#include <string_view>

#include "pal/support/diagnostic_code.hpp"

namespace pal::explain {

struct EmbeddedPage {
  Code code;
  std::string_view markdown;
};

/// Those that there are, sorted by code.
std::span<const EmbeddedPage> embedded_pages();

}  // namespace pal::explain
