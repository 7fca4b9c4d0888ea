// What a fix changes, line by line.
#pragma once

#include <iosfwd>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal {

/// Writes the lines that `edits` change as a difference: each old line with its number and `-`, then what
/// stands in its place with `+`. Other files than the first edit's are named.
void write_suggestion(const std::vector<Edit>& edits, const SourceManager& sources, std::ostream& out);

}  // namespace pal
