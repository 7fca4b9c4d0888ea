#include "language_server/json.hpp"

#include <algorithm>
#include <cstdint>

namespace pal::language_server {

const Json& member(const Json& object, std::string_view name) {
  static const Json null;
  if (!object.is_object()) return null;
  const auto found = object.find(std::string(name));
  return found == object.end() ? null : *found;
}

std::string string_of(const Json& object, std::string_view name) {
  const auto& value = member(object, name);
  return value.is_string() ? value.get<std::string>() : std::string();
}

bool flag_of(const Json& object, std::string_view name, bool otherwise) {
  const auto& value = member(object, name);
  return value.is_boolean() ? value.get<bool>() : otherwise;
}

Position position_of(const Json& value) {
  const auto number = [&](std::string_view name) -> std::uint32_t {
    const auto& each = member(value, name);
    if (!each.is_number_unsigned()) throw Refusal{invalid_params, "a position needs a line and a character"};
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(each.get<std::uint64_t>(), INT32_MAX));
  };
  return {number("line"), number("character")};
}

Json json_of(Position position) {
  return {{"line", position.line}, {"character", position.character}};
}

Json range_of(const Text& text, std::size_t begin, std::size_t end) {
  return {{"start", json_of(text.position(begin))}, {"end", json_of(text.position(end))}};
}

Json text_edit(const Text& text, std::size_t begin, std::size_t end, std::string_view by) {
  return {{"range", range_of(text, begin, end)}, {"newText", std::string(by)}};
}

}  // namespace pal::language_server
