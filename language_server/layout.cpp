// The canonical layout, as the edits that lead to it.
#include "language_server/session.hpp"
#include "pal/syntax/format.hpp"

namespace pal::language_server {

namespace {

/// The edits of lines [first, last] that lay a text out.
Json edits(const Text& text, std::size_t first, std::size_t last) {
  SourceManager sources;
  const FileId file = sources.add("text", text.content());
  const auto start_of = [&](std::size_t line) { return text.offset({static_cast<std::uint32_t>(line), 0}); };
  Json result = Json::array();
  for (const Edit& edit : syntax::layout_edits(sources, file, {file, start_of(first), start_of(last)}))
    result.push_back(text_edit(text, edit.where.begin, edit.where.end, edit.text));
  return result;
}

}  // namespace

Json Session::formatting(const Json& params) {
  const auto text = workspace_.text(path_in(params));
  return text == nullptr ? Json() : edits(*text, 0, text->lines());
}

Json Session::range_formatting(const Json& params) {
  const auto text = workspace_.text(path_in(params));
  if (text == nullptr) return nullptr;
  const Json& range = member(params, "range");
  return edits(*text, position_of(member(range, "start")).line, position_of(member(range, "end")).line);
}

}  // namespace pal::language_server
