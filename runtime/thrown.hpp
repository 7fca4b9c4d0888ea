// What was thrown, in words.
#pragma once

#include <string>

namespace pal::runtime {

/// Of the exception that is being handled: its text, or that it is none of the standard library's kind. To be
/// called in a handler only.
std::string what_was_thrown();

}  // namespace pal::runtime
