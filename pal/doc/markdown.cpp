// A document as Markdown.
#include <algorithm>
#include <string_view>

#include "pal/doc/document.hpp"

namespace pal::doc {

namespace {

/// What CommonMark or its tables could take for more than text.
std::string escaped(std::string_view text) {
  constexpr std::string_view meaning_anywhere = "\\`*_[]<>|~&";
  constexpr std::string_view meaning_first = "#+-=";
  std::string result;
  for (const char c : text) {
    const bool first = result.empty() && meaning_first.find(c) != std::string_view::npos;
    if (first || meaning_anywhere.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  // "1. " or "1) " at the beginning would be the first item of a list.
  const auto digits = result.find_first_not_of("0123456789");
  const bool counted =
      digits != 0 && digits != std::string::npos && (result[digits] == '.' || result[digits] == ')');
  if (counted && (digits + 1 == result.size() || result[digits + 1] == ' ')) {
    result.insert(digits, "\\");
  }
  return result;
}

/// As code, between more backticks than there are in a row in it; in a table a bar still divides.
std::string as_code(const std::string& text, bool in_table) {
  std::size_t longest = 0;
  std::size_t row = 0;
  std::string content;
  for (const char c : text) {
    row = c == '`' ? row + 1 : 0;
    longest = std::max(longest, row);
    if (c == '|' && in_table) content += '\\';
    content += c;
  }
  const std::string fence(longest + 1, '`');
  const std::string space = longest != 0 ? " " : "";
  return fence + space + content + space + fence;
}

std::string markdown_text(const Line& line, bool in_table = false) {
  std::string result;
  for (const auto& span : line) result += span.is_code ? as_code(span.text, in_table) : escaped(span.text);
  return result;
}

struct BlockText {
  std::string operator()(const Paragraphs& paragraphs) const {
    std::string result;
    for (const auto& line : paragraphs.lines)
      result += (result.empty() ? "" : "\n") + markdown_text(line) + "\n";
    return result;
  }
  std::string operator()(const Items& items) const {
    std::string result;
    for (const auto& line : items.lines) result += "- " + markdown_text(line) + "\n";
    return result;
  }
  std::string operator()(const Table& table) const {
    std::string result = "|";
    for (const auto& head : table.heads) result += " " + escaped(head) + " |";
    result += "\n|";
    for (std::size_t i = 0; i < table.heads.size(); ++i) result += " --- |";
    for (const auto& row : table.rows) {
      result += "\n|";
      for (const auto& cell : row) result += " " + markdown_text(cell, true) + " |";
    }
    return result + "\n";
  }
  std::string operator()(const Picture& picture) const {
    return "![" + escaped(picture.title) + "](<" + picture.file + ">)\n";
  }
};

}  // namespace

std::string markdown(const Line& line) {
  return markdown_text(line);
}

std::string markdown(const Document& document) {
  std::string result = "# " + escaped(document.title) + "\n";
  for (const auto& part : document.parts) {
    result += "\n## " + escaped(part.title) + "\n";
    for (const auto& section : part.sections) {
      result += "\n### " + escaped(section.title) + "\n";
      for (const auto& block : section.blocks) result += "\n" + std::visit(BlockText{}, block);
      if (section.blocks.empty()) result += "\nNone.\n";
    }
  }
  return result;
}

}  // namespace pal::doc
