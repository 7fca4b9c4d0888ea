// Files that are whole after a crash at any instant, and refusals of what keeps things on the disk.
#pragma once

#include <cstddef>
#include <string>

#include "server/command.hpp"

namespace pal::server {

/// Why something that is kept is not changed or read.
struct StoreProblem {
  Refusal refusal;
};

/// Throws StoreProblem.
[[noreturn]] void refuse(Refusal::Why why, std::string message, std::string hint = {});
/// Likewise with the system's reason, of `errno`.
[[noreturn]] void fail_on_disk(const std::string& path);

/// An open file. Functions throw StoreProblem.
class DiskFile {
 public:
  /// `flags` are those of open(2).
  DiskFile(const std::string& path, int flags);
  ~DiskFile();
  DiskFile(const DiskFile&) = delete;
  DiskFile& operator=(const DiskFile&) = delete;

  void write(const std::string& path, const std::string& text) const;
  void sync(const std::string& path) const;
  /// Of at most so many bytes.
  std::string read(const std::string& path, std::size_t most) const;

 private:
  int number_;
};

/// New and renamed files of the folder are on the disk.
void sync_folder(const std::string& folder);
/// Whole on the disk under a name in the folder that nothing looks at; the answer is its path.
std::string write_aside(const std::string& folder, const std::string& text);
/// The file has the new text or the old one, whole, at any instant.
void replace_file(const std::string& folder, const std::string& name, const std::string& text);

}  // namespace pal::server
