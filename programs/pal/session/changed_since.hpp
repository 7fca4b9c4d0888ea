// Skills that nothing touched since a revision of git.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "programs/pal/session/selection.hpp"
#include "programs/pal/session/unchecked.hpp"

namespace pal::program {

/// A skill in an environment of which no file differs from the revision.
struct LeftOut {
  const pan::Network* skill = nullptr;
  const pan::Environment* environment = nullptr;
  std::string reason;  // "none of its 7 files has changed since main"
};

/// Those of a session that was read without errors. A proof depends on the skill's file, on all files that it
/// uses, and on the environment's. They are compared as they are now, committed or not; a file that git does
/// not know counts as changed. A text: what went wrong.
std::variant<std::vector<LeftOut>, std::string> unchanged_since(const std::string& revision,
                                                                const Session& session);

/// Marks the requirements of those that were left out, and says why they were.
void mark_left_out(const std::vector<LeftOut>& left_out, std::vector<Unchecked>& not_checked);

}  // namespace pal::program
