// Where texts come from: the disk, or a test's strings.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pal {

/// Why a file could not be read: a phrase that completes "cannot read 'x': …".
struct FileError {
  std::string reason;
};

/// The greatest size of a text.
constexpr std::size_t largest_file = std::size_t{16} << 20;

/// The greatest size of a file with runs: programs write these, and there may be thousands in one file.
constexpr std::size_t largest_runs = std::size_t{1024} << 20;

class FileSystem {
 public:
  virtual ~FileSystem() = default;

  /// The whole file, byte for byte, if it has no more than `most`. Never throws.
  virtual std::variant<std::string, FileError> read(const std::string& path,
                                                    std::size_t most = largest_file) const = 0;

  /// The paths of all files in the directory `path` and those below it, in order, whose names end in
  /// `ending`; hidden ones are left out. Nothing if it is no directory, or cannot be read. Never throws.
  virtual std::optional<std::vector<std::string>> list(const std::string& /*path*/,
                                                       std::string_view /*ending*/) const {
    return std::nullopt;
  }

  /// Equal for two paths that lead to one file, by links or otherwise, and for no others. Never throws.
  virtual std::string identity(const std::string& path) const;
};

/// The real one. Refuses directories.
class DiskFileSystem : public FileSystem {
 public:
  std::variant<std::string, FileError> read(const std::string& path,
                                            std::size_t most = largest_file) const override;
  std::optional<std::vector<std::string>> list(const std::string& path,
                                               std::string_view ending) const override;
  std::string identity(const std::string& path) const override;
};

/// Files that are strings.
class MemoryFileSystem : public FileSystem {
 public:
  MemoryFileSystem() = default;
  explicit MemoryFileSystem(std::map<std::string, std::string> files) : files_(std::move(files)) {}

  void add(std::string path, std::string text) { files_[std::move(path)] = std::move(text); }
  std::variant<std::string, FileError> read(const std::string& path,
                                            std::size_t most = largest_file) const override;
  std::optional<std::vector<std::string>> list(const std::string& path,
                                               std::string_view ending) const override;

 private:
  std::map<std::string, std::string> files_;
};

/// The path of `named` as the file `naming` means it: relative to the folder of `naming`, without "." and
/// "x/..".
std::string resolve_path(const std::string& naming, const std::string& named);

}  // namespace pal
