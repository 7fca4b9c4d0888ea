// The names of the kinds of semantic tokens, in the order of their numbers.
#pragma once

#include <string>
#include <vector>

namespace pal::language_server {

enum class TokenType { keyword, number, string, comment, operators, skill, module, device, message, field, condition, activity, parameter, requirement, code, environment, processor };

inline std::vector<std::string> token_types() {
  return {"keyword", "number",   "string",   "comment",  "operator", "class", "namespace", "interface", "struct",
          "property", "variable", "function", "parameter", "event",    "enumMember", "type", "typeParameter"};
}
inline std::vector<std::string> token_modifiers() {
  return {"declaration"};
}

}  // namespace pal::language_server
