// Events as clients at a line see them.
#pragma once

#include <string>

#include "server/event.hpp"

namespace pal::server {

/// Its number, what it is, and a few words.
std::string event_line(const Event& event);

}  // namespace pal::server
