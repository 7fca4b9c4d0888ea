#include "language_server/operation_text.hpp"

#include <algorithm>

namespace pal::language_server {

namespace {

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '+' ||
         c == '.' || c == '_';
}

/// A word or a sign of a text.
struct Piece {
  std::size_t begin = 0, end = 0;
  bool text = false;    // between quotation marks
  bool closed = false;  // … of which the second is there
};

/// The next one from `at` on; nothing at the end. A text ends with its line at the latest.
std::optional<Piece> next_piece(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\n' || text[at] == '\r'))
    ++at;
  if (at >= text.size()) return std::nullopt;
  std::size_t end = at + 1;
  if (text[at] == '"') {
    while (end < text.size() && text[end] != '"' && text[end] != '\n' && text[end] != '\r')
      end += text[end] == '\\' && end + 1 < text.size() && text[end + 1] != '\n' ? 2 : 1;
    const bool closed = end < text.size() && text[end] == '"';
    return Piece{at, std::min(end + (closed ? 1 : 0), text.size()), true, closed};
  }
  while (is_word(text[at]) && end < text.size() && is_word(text[end])) ++end;
  return Piece{at, end, false, false};
}

std::string inside(std::string_view text, const Piece& piece) {
  if (!piece.text) return std::string(text.substr(piece.begin, piece.end - piece.begin));
  const auto length = piece.end - piece.begin - (piece.closed ? 2 : 1);
  return std::string(text.substr(piece.begin + 1, length));
}

}  // namespace

JsonPlace json_place(std::string_view text, std::size_t offset) {
  JsonPlace place;
  bool value = false;  // behind a colon
  place.begin = place.end = offset;
  for (auto piece = next_piece(text, 0); piece; piece = next_piece(text, piece->end)) {
    const char sign = text[piece->begin];
    const bool word = piece->text || is_word(sign);
    if (word ? piece->begin >= offset && !(piece->begin == offset) : piece->begin >= offset) break;
    const bool names = !place.frames.empty() && place.frames.back().object && !value;
    if (word) {
      if (names && piece->end < offset) place.frames.back().key = inside(text, *piece);
      if (piece->end < offset ||
          (piece->closed && piece->end == offset && piece->text && piece->begin != offset)) {
        if (names) place.frames.back().key = inside(text, *piece);
        if (piece->end < offset) continue;
      }
      place.begin = piece->begin;
      place.end = piece->end;
      place.word = inside(text, *piece);
      place.in_text = piece->text && offset > piece->begin && (!piece->closed || offset < piece->end);
      break;
    }
    if (sign == '{' || sign == '[') {
      place.frames.push_back({sign == '{', {}, piece->begin});
      value = false;
    } else if (sign == '}' || sign == ']') {
      if (!place.frames.empty()) place.frames.pop_back();
      value = true;
    } else if (sign == ':') {
      value = true;
    } else if (sign == ',') {
      value = false;
      if (!place.frames.empty()) place.frames.back().key.clear();
    }
  }
  place.names_member = !place.frames.empty() && place.frames.back().object && !value;
  return place;
}

std::optional<std::string> json_member(std::string_view text, std::size_t open, std::string_view name) {
  int depth = 0;
  std::string key;
  bool value = false;
  for (auto piece = next_piece(text, open); piece; piece = next_piece(text, piece->end)) {
    const char sign = text[piece->begin];
    if (piece->text) {
      if (depth == 1 && !value) key = inside(text, *piece);
      if (depth == 1 && value && key == name) return inside(text, *piece);
    } else if (sign == '{' || sign == '[') {
      ++depth;
    } else if (sign == '}' || sign == ']') {
      if (--depth == 0) return std::nullopt;
    } else if (depth == 1) {
      value = sign == ':' || (value && sign != ',');
    }
  }
  return std::nullopt;
}

}  // namespace pal::language_server
