#include "language_server/framing.hpp"

#include <cctype>
#include <charconv>
#include <istream>
#include <optional>
#include <ostream>

namespace pal::language_server {

namespace {

/// A line of a header is short; more is no header, and is dropped as it is read.
constexpr std::size_t longest_line = 4096;

std::optional<std::string> header_line(std::istream& in) {
  std::string line;
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n') {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return line;
    }
    if (line.size() < longest_line) line += static_cast<char>(c);
  }
  return std::nullopt;
}

bool is_length(std::string_view name) {
  constexpr std::string_view wanted = "content-length";
  if (name.size() != wanted.size()) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(name[i])) != wanted[i]) return false;
  }
  return true;
}

std::optional<std::size_t> number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

}  // namespace

std::variant<std::string, EndOfInput, BadHeader> read_message(std::istream& in) {
  std::optional<std::size_t> length;
  std::string wrong;
  bool any = false;
  for (;;) {
    const auto line = header_line(in);
    if (!line) return EndOfInput{};
    if (line->empty()) {
      if (any) break;
      continue;  // between messages
    }
    any = true;
    const auto colon = line->find(':');
    if (colon == std::string::npos) {
      wrong = "a line of a header is no 'name: value'";
    } else if (is_length(std::string_view(*line).substr(0, colon))) {
      length = number(std::string_view(*line).substr(colon + 1));
      if (!length) wrong = "the Content-Length is no number";
    }
  }
  if (!wrong.empty()) return BadHeader{wrong};
  if (!length) return BadHeader{"the header has no Content-Length"};
  if (*length > longest_message) return BadHeader{"the message is longer than 256 MB"};
  std::string content;
  constexpr std::size_t piece = std::size_t{1} << 16;  // a length that is not true takes no memory
  while (content.size() < *length) {
    const std::size_t had = content.size();
    content.resize(std::min(*length, had + piece));
    in.read(content.data() + had, static_cast<std::streamsize>(content.size() - had));
    if (static_cast<std::size_t>(in.gcount()) < content.size() - had) return EndOfInput{};
  }
  return content;
}

void write_message(std::string_view content, std::ostream& out) {
  out << "Content-Length: " << content.size() << "\r\n\r\n" << content << std::flush;
}

}  // namespace pal::language_server
