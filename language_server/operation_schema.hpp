// What may stand at a place of an operation's file, by the published schema.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language_server/operation_text.hpp"

namespace pal::language_server {

/// operations/schema/operation.schema.json.
std::string_view operation_schema_text();

struct SchemaMember {
  std::string name;
  std::string type;   // "a number from 0 to 86400"; empty: several forms
  std::string words;  // what it is for; may be empty
  /// Its values as JSON, if the schema lists them.
  std::vector<std::string> values;
};

/// The members that the innermost object around the place may have, by their names. Of an icon, those of its
/// kind; if the text does not say the kind yet, those of all kinds. Empty: the place is in no object that
/// the schema knows.
std::vector<SchemaMember> members_at(std::string_view text, const JsonPlace& place);

}  // namespace pal::language_server
