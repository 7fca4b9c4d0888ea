// JSON whose values know their places, so that a finding can name a line.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::operations {

struct JsonMember;

struct JsonValue {
  enum class Kind { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  bool truth = false;
  double number = 0;
  bool whole = false;  // the number was written without a fraction
  std::string text;
  std::vector<JsonValue> items;
  std::vector<JsonMember> members;  // in the order of the file
  SourceSpan where;
};

struct JsonMember {
  std::string name;
  SourceSpan where;
  JsonValue value;
};

/// Reads the text of `file`. If it is not JSON, reports PAL1001 and returns nothing.
std::optional<JsonValue> parse_json(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::operations
