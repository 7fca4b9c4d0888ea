#include "language_server/text.hpp"

#include <algorithm>
#include <utility>

#include "pal/support/utf8.hpp"

namespace pal::language_server {

namespace {

std::uint32_t units(char32_t code_point) {
  return code_point >= 0x10000 ? 2 : 1;
}

}  // namespace

std::string capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return result;
}

Text::Text(std::string content) : content_(std::move(content)) {
  find_lines();
}

void Text::find_lines() {
  starts_.assign(1, 0);
  for (std::size_t i = 0; i < content_.size(); ++i) {
    const bool lone_return = content_[i] == '\r' && (i + 1 == content_.size() || content_[i + 1] != '\n');
    if (content_[i] == '\n' || lone_return) starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

std::string_view Text::line(std::size_t number) const {
  if (number >= starts_.size()) return {};
  const std::size_t begin = starts_[number];
  const std::size_t end = number + 1 < starts_.size() ? starts_[number + 1] : content_.size();
  auto line = std::string_view(content_).substr(begin, end - begin);
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  return line;
}

std::uint32_t Text::offset(Position position) const {
  if (position.line >= starts_.size()) return static_cast<std::uint32_t>(content_.size());
  auto rest = line(position.line);
  std::uint32_t offset = starts_[position.line];
  std::uint32_t column = 0;
  while (!rest.empty() && column < position.character) {
    const auto next = utf8::decode(rest);
    column += units(next.code_point);
    if (column > position.character) break;  // within a pair: before it
    offset += static_cast<std::uint32_t>(next.bytes);
    rest.remove_prefix(next.bytes);
  }
  return offset;
}

Position Text::position(std::size_t offset) const {
  offset = std::min(offset, content_.size());
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto number = static_cast<std::size_t>(after - starts_.begin()) - 1;
  auto before = std::string_view(content_).substr(starts_[number], offset - starts_[number]);
  std::uint32_t column = 0;
  while (!before.empty()) {
    const auto next = utf8::decode(before);
    column += units(next.code_point);
    before.remove_prefix(next.bytes);
  }
  return {static_cast<std::uint32_t>(number), column};
}

void Text::replace(Position from, Position to, std::string_view by) {
  auto begin = offset(from);
  auto end = offset(to);
  if (end < begin) std::swap(begin, end);
  content_.replace(begin, end - begin, by);
  find_lines();
}

}  // namespace pal::language_server
