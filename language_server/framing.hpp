// Messages on a stream: a header with the length, an empty line, then JSON (LSP 3.17, base protocol).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>

namespace pal::language_server {

/// The longest message that is read.
constexpr std::size_t longest_message = std::size_t{256} << 20;

struct EndOfInput {};
/// A header without a length, or with one that means nothing. What follows cannot be told apart any more, up
/// to the next header.
struct BadHeader {
  std::string reason;
};

/// The content of the next message. After a BadHeader the next call goes on behind the next empty line.
std::variant<std::string, EndOfInput, BadHeader> read_message(std::istream& in);

/// Writes one, and flushes.
void write_message(std::string_view content, std::ostream& out);

}  // namespace pal::language_server
