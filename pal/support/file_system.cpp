#include "pal/support/file_system.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace pal {

namespace {

std::string larger_than(std::size_t most) {
  return "it is larger than " + std::to_string(most >> 20) + " MB";
}

}  // namespace

std::variant<std::string, FileError> DiskFileSystem::read(const std::string& path, std::size_t most) const {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return FileError{"no such file"};
  if (error) return FileError{error.message()};
  if (status.type() == fs::file_type::directory) return FileError{"it is a directory"};

  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) return FileError{errno != 0 ? std::generic_category().message(errno) : "it cannot be opened"};
  // Read in pieces: a pipe has no size to ask for, and a file may grow meanwhile.
  std::string text;
  constexpr std::size_t piece = std::size_t{1} << 16;
  while (in) {
    const auto had = text.size();
    if (had > most) return FileError{larger_than(most)};
    text.resize(had + piece);
    in.read(text.data() + had, static_cast<std::streamsize>(piece));
    text.resize(had + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) return FileError{"reading it failed"};
  if (text.size() > most) return FileError{larger_than(most)};
  text.shrink_to_fit();  // of thousands of small files the pieces would be most
  return text;
}

std::optional<std::vector<std::string>> DiskFileSystem::list(const std::string& path,
                                                             std::string_view ending) const {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::recursive_directory_iterator entry(path, error);
  if (error) return std::nullopt;
  std::vector<std::string> found;
  for (const fs::recursive_directory_iterator end; entry != end;) {
    const auto name = entry->path().filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) {
      entry.disable_recursion_pending();
    } else if (name.ends_with(ending) && entry->symlink_status(ignored).type() == fs::file_type::regular) {
      found.push_back(entry->path().string());
    }
    entry.increment(error);
    if (error) return std::nullopt;
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string FileSystem::identity(const std::string& path) const {
  return resolve_path({}, path);
}

/// Of what is no file, a pipe say, each reading may give something else.
std::string DiskFileSystem::identity(const std::string& path) const {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return FileSystem::identity(path);
  return "file " + std::to_string(found.st_dev) + " " + std::to_string(found.st_ino);
}

std::optional<std::vector<std::string>> MemoryFileSystem::list(const std::string& path,
                                                               std::string_view ending) const {
  const auto folder = path.ends_with('/') ? path : path + '/';
  std::vector<std::string> found;
  bool exists = false;
  for (const auto& [name, text] : files_) {
    if (!name.starts_with(folder)) continue;
    exists = true;
    if (name.ends_with(ending) && name.find("/.", folder.size() - 1) == std::string::npos)
      found.push_back(name);
  }
  return exists ? std::optional(found) : std::nullopt;
}

std::variant<std::string, FileError> MemoryFileSystem::read(const std::string& path, std::size_t most) const {
  const auto found = files_.find(path);
  if (found == files_.end()) return FileError{"no such file"};
  if (found->second.size() > most) return FileError{larger_than(most)};
  return found->second;
}

std::string resolve_path(const std::string& naming, const std::string& named) {
  const auto folder = std::filesystem::path(naming).parent_path();
  return (folder / std::filesystem::path(named)).lexically_normal().string();
}

}  // namespace pal
