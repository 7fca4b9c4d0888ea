// The conditions of CASE and UNTIL as the author of a text wrote them: drawings show them so.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// By the file and the byte at which a CASE or an UNTIL begins: the conditions of its arms in order, or its
/// own.
using WrittenConditions = std::map<std::pair<FileId, std::uint32_t>, std::vector<std::string>>;

/// Adds those of a file of PAL, without the parentheses around them, in one line. A condition with a comment
/// inside is "".
void add_written_conditions(const Tree& tree, const SourceManager& sources, WrittenConditions& to);

}  // namespace pal::syntax
