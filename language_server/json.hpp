// Values of the protocol. Private to language_server: shows nlohmann's JSON.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "language_server/text.hpp"
#include "pal/support/source.hpp"

namespace pal::language_server {

using Json = nlohmann::json;

/// What the protocol answers instead of a result. Thrown by requests, caught where they are answered.
struct Refusal {
  int code = 0;
  std::string message;
};
constexpr int parse_error = -32700;
constexpr int invalid_request = -32600;
constexpr int method_not_found = -32601;
constexpr int invalid_params = -32602;
constexpr int internal_error = -32603;
constexpr int server_not_initialized = -32002;
constexpr int request_cancelled = -32800;
constexpr int request_failed = -32803;

/// The member of an object, or null.
const Json& member(const Json& object, std::string_view name);
std::string string_of(const Json& object, std::string_view name);
bool flag_of(const Json& object, std::string_view name, bool otherwise = false);

/// Refuses what is no position.
Position position_of(const Json& value);
Json json_of(Position position);
Json range_of(const Text& text, std::size_t begin, std::size_t end);

/// One edit of a text.
Json text_edit(const Text& text, std::size_t begin, std::size_t end, std::string_view by);

}  // namespace pal::language_server
