// Files are written whole or not at all.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace pal {

struct OutputFile {
  std::string path;
  std::string content{};
  /// Writes a content that is too long to be held; empty: `content` is it.
  std::function<void(std::ostream&)> write{};
};

/// Writes every file, and makes missing folders. Each file is first written beside its place, under a name
/// that nothing else has; when all are written, they are renamed. A file that exists keeps its permissions;
/// for a link, the file that it leads to is written. A pipe or a device (/dev/stdout) is written directly.
/// Returns what went wrong, with the path, or nothing.
std::optional<std::string> write_files(const std::vector<OutputFile>& files);

/// Whether write_files() could write a file there now, for those who would learn it only after long work.
/// Leaves nothing behind. Returns what is in the way, with the path, or nothing.
std::optional<std::string> cannot_be_written(const std::string& path);

}  // namespace pal
