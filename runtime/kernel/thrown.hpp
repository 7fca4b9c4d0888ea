// Exceptions in words.
#pragma once

#include <string>

namespace pal::runtime {

/// The text of the exception that is being handled, or that it is not one of the standard library's kind. To
/// be called in a handler only.
std::string what_was_thrown();

}  // namespace pal::runtime
