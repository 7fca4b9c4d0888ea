// The name under which a proof is kept: a hash of all that it depends on, and of nothing else.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::study {

/// SHA-256, 64 hexadecimal digits.
std::string sha256(std::string_view text);

/// All that a network or an environment holds but its places in the text: comments and moves of lines change
/// nothing. A network has the modules that the skill uses.
std::string canonical_text(const pan::Network& skill);
std::string canonical_text(const pan::Environment& environment);

/// The version and the build of this program. Another build has another one, so that no proof outlives the
/// code that made it.
const std::string& engine_version();

/// What decides beside skill and environment. A limit of time or memory is not among them: what such a limit
/// ended is never kept.
struct KeyOptions {
  std::string analysis;  // as --analysis has it
  std::size_t max_states = 0;
};

/// `skill` and `environment` are hashes of their canonical texts.
std::string proof_key(const std::string& skill, const std::string& environment, const KeyOptions& options);

}  // namespace pal::study
