// Operations as files.
#pragma once

#include <string>

#include "operations/model.hpp"

namespace pal::operations {

/// The canonical form of a document: fields in a fixed order, an icon a line, icons in their order. So two
/// versions differ in the lines of the icons that differ. parse() of it gives the same document.
std::string write(const Document& document);

}  // namespace pal::operations
