// UTF-8, as much of it as source texts need.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace pal::utf8 {

/// The code point that begins `text` and the bytes it takes. Of bytes that are no UTF-8: U+FFFD and one byte.
/// Contract: `text` is not empty.
struct Decoded {
  char32_t code_point;
  std::size_t bytes;
  bool valid;
};
Decoded decode(std::string_view text);

/// Code points in `text`; a byte that is no UTF-8 counts as one.
std::size_t length(std::string_view text);

/// Offset of the first byte that is no UTF-8 (RFC 3629: no overlong form, no surrogate, nothing above
/// U+10FFFF).
std::optional<std::size_t> first_invalid(std::string_view text);

}  // namespace pal::utf8
