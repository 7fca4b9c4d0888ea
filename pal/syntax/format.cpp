#include "pal/syntax/format.hpp"

#include "pal/syntax/layout.hpp"
#include "pal/syntax/lines.hpp"
#include "pal/syntax/reading.hpp"

namespace pal::syntax {

std::optional<std::string> format(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto text = sources.text(file);
  const Reading reading(file, text, diagnostics);
  if (!reading.complete()) return std::nullopt;
  return lay_out(lines_of(reading, text));
}

}  // namespace pal::syntax
