// Files are written whole or not at all.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pal {

struct OutputFile {
  std::string path;
  std::string content;
};

/// Writes every file, making folders that are missing; each is written beside its place, under a name that
/// nothing else has, and then renamed, and nothing is renamed before all are written. A file that is there
/// keeps its permissions; of a link the file that it leads to is written. A pipe or a device (/dev/stdout) is
/// written itself, and stays what it is. Returns what went wrong, with the path, or nothing.
std::optional<std::string> write_files(const std::vector<OutputFile>& files);

}  // namespace pal
