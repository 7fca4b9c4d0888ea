// All findings at a glance, and all their pages in one document.
#pragma once

#include <iosfwd>

#include "pal/support/diagnostic_code.hpp"

namespace pal::explain {

/// A line a code: code, severity, title.
void write_list(std::ostream& out);

/// One page, below its code, severity and title; as Markdown.
void write_page(Code code, std::ostream& out);

/// docs/reference/diagnostics.md: the list as a table that links to the pages, then the pages.
void write_reference(std::ostream& out);

}  // namespace pal::explain
