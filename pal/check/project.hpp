// Which files of a folder belong together: the skills that use a file, and the environments for a skill
// (docs/reference/language-server.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::check {

/// What one file says of others, found without parsing it; paths are normalized.
struct ProjectFile {
  std::string path;
  std::vector<std::string> uses;
  bool has_skill = false;
  bool has_environment = false;
};

/// Reads `text`, the content of `path`, as far as it has words. Never throws.
ProjectFile project_file(const std::string& path, std::string_view text);

/// The files with a skill that see `path`, in the order of `files`; itself, if it has one. Empty: no skill
/// uses it.
std::vector<std::string> skills_that_see(const std::vector<ProjectFile>& files, const std::string& path);

/// `path` and all files that it sees, as far as they are in `files`.
std::vector<std::string> seen_by(const std::vector<ProjectFile>& files, const std::string& path);

/// The files whose environments may be meant for the skill in the file `skill`. If what it sees has one: none
/// besides. Else those of its folder, or of the nearest folder above with any, up to `top`.
std::vector<std::string> environments_near(const std::vector<ProjectFile>& files, const std::string& skill,
                                           const std::string& top);

/// The first of `environments` that has all that `skill` needs, else the first; nothing if there is none.
std::optional<std::size_t> fitting_environment(const pan::Network& skill,
                                               const std::vector<pan::Environment>& environments);

}  // namespace pal::check
