#include "pal/syntax/parse.hpp"

#include <algorithm>
#include <string_view>

#include "pal/syntax/build.hpp"
#include "pal/syntax/reading.hpp"

namespace pal::syntax {

namespace {

/// The whole line on which `place` begins.
SourceSpan line_of(const SourceManager& sources, SourceSpan place) {
  const auto text = sources.text(place.file);
  const auto end = std::min(text.find('\n', place.begin), text.size());
  const auto before = place.begin == 0 ? std::string_view::npos : text.rfind('\n', place.begin - 1);
  const auto begin = before == std::string_view::npos ? 0 : before + 1;
  return {place.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

Tree parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto findings_before = diagnostics.all().size();
  const Reading reading(file, sources.text(file), diagnostics);
  if (reading.root() == nullptr) return {file, false, true, {}};
  // What a mended line seems to say is not held against it.
  for (auto i = findings_before; i < diagnostics.all().size(); ++i) {
    diagnostics.distrust(line_of(sources, diagnostics.all()[i].where));
  }
  auto tree = Builder(reading.tokens(), diagnostics).build(reading.root());
  tree.complete = reading.complete();
  tree.lost = reading.lost();
  return tree;
}

}  // namespace pal::syntax
