// Where a place of a JSON text stands, also of one that is being typed and is no JSON yet.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pal::language_server {

/// An object or a list around a place.
struct JsonFrame {
  bool object = true;
  std::string key;       // in an object: of the member that the place is in, or that is being named
  std::size_t open = 0;  // its first sign
};

struct JsonPlace {
  std::vector<JsonFrame> frames;   // from the outermost
  bool names_member = false;       // a name of a member may stand here, or does
  bool in_text = false;            // between quotation marks
  std::size_t begin = 0, end = 0;  // of the word at the place, with its quotation marks
  std::string word;                // without them
};

/// The place at byte `offset` of `text`. Never throws.
JsonPlace json_place(std::string_view text, std::size_t offset);

/// The text that is the value of a member of the object that begins at `open`; nothing: it has none.
std::optional<std::string> json_member(std::string_view text, std::size_t open, std::string_view name);

}  // namespace pal::language_server
