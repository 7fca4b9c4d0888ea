// JSON documents as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pal::program {

/// The document with `indent` blanks a level; without, in one line. The name of a file may hold any bytes:
/// those that are no UTF-8 become U+FFFD, so that the text is JSON whatever it tells.
inline std::string json_text(const nlohmann::ordered_json& document, int indent = -1) {
  return document.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace pal::program
