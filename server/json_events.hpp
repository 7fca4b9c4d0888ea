// Events as the JSON protocol tells them.
#pragma once

#include <string>

#include "server/event.hpp"

namespace pal::server {

/// In one line, the params of a notification `event`.
std::string event_text(const Event& event);

}  // namespace pal::server
