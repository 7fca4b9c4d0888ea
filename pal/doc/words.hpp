// Types and messages in words, as documents and editors tell them.
#pragma once

#include <string>

#include "pal/pan/network.hpp"

namespace pal::doc {

/// What a message carries: "fx, fy, fz: real, in N; on: boolean".
std::string content_of(const pan::Message& message);
/// "real, in N"; "boolean".
std::string type_text(pan::ScalarType type, const std::string& unit, int size = 0);

}  // namespace pal::doc
