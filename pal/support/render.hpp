// Findings as people and as programs read them.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/source.hpp"

namespace pal {

/// How much of the findings text shows.
struct TextLimit {
  std::size_t most = 0;    // findings, errors before warnings; 0: all
  FindingCounts not_kept;  // found besides, as Diagnostics::not_kept() says
};

/// Writes each finding with its code, its place as file:line:column, and the line it stands on, with carets
/// below the place. Then come the notes at their own places, the hint, and what its fix changes. Ends with a
/// line that says how many more there are than are shown, if any, and one that counts errors and warnings.
/// `findings` as Diagnostics::sorted() gives them.
void render_text(const std::vector<Diagnostic>& findings, const SourceManager& sources, std::ostream& out,
                 const TextLimit& limit = {});

/// A JSON array of one object each: {"code", "severity", "file", "line", "column", "end_line", "end_column",
/// "message", "hint", "hint_for", "finding", "arguments": {placeholder: text}, "notes": [{"file", "line",
/// "column", "end_line", "end_column", "message"}], "fix": [{"file", "line", "column", "end_line",
/// "end_column", "text"}]}. What has no place has "" and 0.
std::string render_json(const std::vector<Diagnostic>& findings, const SourceManager& sources);

}  // namespace pal
