#include "pal/support/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace pal {
namespace {

namespace fs = std::filesystem;

/// A place for the content of a file until all are written.
struct Draft {
  std::string target;
  std::string path;  // beside the target; a pipe or a device is written itself, and has none
};

/// Temporary files that are removed unless they were renamed into place.
class Drafts {
 public:
  ~Drafts() {
    std::error_code ignored;
    for (const Draft& draft : all_) {
      if (!draft.path.empty()) fs::remove(draft.path, ignored);
    }
  }

  void add(Draft draft) { all_.push_back(std::move(draft)); }
  const std::vector<Draft>& all() const { return all_; }

 private:
  std::vector<Draft> all_;
};

std::string cannot_write(const std::string& path) {
  return "cannot write " + path + ": is the folder writable and is there space?";
}

/// The path of a new, empty file in the folder of `target`. It is neither a file of the user nor that of
/// another run for the same target. Empty: there cannot be one.
std::string new_file_beside(const fs::path& target) {
  const std::string stem = ".pal-" + std::to_string(getpid()) + "-";
  for (int number = 0;; ++number) {
    std::string path = (target.parent_path() / (stem + std::to_string(number) + ".part")).string();
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return path;
    }
    if (errno != EEXIST) return {};
  }
}

bool write_content(const std::string& path, const OutputFile& file) {
  std::ofstream out(path, std::ios::binary);
  if (file.write)
    file.write(out);
  else
    out.write(file.content.data(), static_cast<std::streamsize>(file.content.size()));
  out.close();
  return static_cast<bool>(out);
}

/// Behind links: the file that is written, not the name by which it is known.
std::string behind_links(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const auto target = fs::canonical(path, error);
  return error ? path : target.string();
}

/// Makes the folder that a file will stand in. Returns what went wrong, or nothing.
std::optional<std::string> make_folder_of(const fs::path& path) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (error) return "cannot make the folder " + path.parent_path().string() + ": " + error.message();
  if (fs::is_directory(path, error)) return "cannot write " + path.string() + ": it is a folder";
  return std::nullopt;
}

/// The outermost of the folders around a file that is not there yet; empty: all are.
fs::path first_missing_folder(const fs::path& path) {
  fs::path missing;
  std::error_code ignored;
  for (fs::path folder = path.parent_path(); !folder.empty() && !fs::exists(folder, ignored);
       folder = folder.parent_path())
    missing = folder;
  return missing;
}

std::optional<std::string> write_draft(const OutputFile& file, Drafts& drafts) {
  const fs::path path(file.path);
  if (auto problem = make_folder_of(path)) return problem;
  std::error_code error;
  const fs::file_status old = fs::status(path, error);
  if (fs::exists(old) && !fs::is_regular_file(old)) {
    drafts.add({file.path, ""});
    return std::nullopt;
  }
  const std::string target = behind_links(file.path);
  drafts.add({target, new_file_beside(target)});
  const std::string& draft = drafts.all().back().path;
  if (draft.empty() || !write_content(draft, file)) return cannot_write(file.path);
  if (fs::exists(old)) fs::permissions(draft, old.permissions(), error);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> write_files(const std::vector<OutputFile>& files) {
  std::set<std::string> paths;
  for (const OutputFile& file : files) {
    if (!paths.insert(behind_links(file.path)).second)
      return "cannot write " + file.path + ": two files would have this name";
  }
  Drafts drafts;
  for (const OutputFile& file : files) {
    if (auto problem = write_draft(file, drafts)) return problem;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (drafts.all()[i].path.empty() && !write_content(files[i].path, files[i]))
      return cannot_write(files[i].path);
  }
  for (const Draft& draft : drafts.all()) {
    std::error_code error;
    if (!draft.path.empty()) fs::rename(draft.path, draft.target, error);
    if (error) return "cannot write " + draft.target + ": " + error.message();
  }
  return std::nullopt;
}

std::optional<std::string> cannot_be_written(const std::string& path) {
  const fs::path missing = first_missing_folder(path);
  std::optional<std::string> problem = make_folder_of(path);
  std::error_code ignored;
  const fs::file_status old = fs::status(path, ignored);
  if (!problem && (!fs::exists(old) || fs::is_regular_file(old))) {
    Drafts drafts;
    drafts.add({path, new_file_beside(behind_links(path))});
    if (drafts.all().back().path.empty()) problem = cannot_write(path);
  }
  if (!missing.empty()) fs::remove_all(missing, ignored);
  return problem;
}

}  // namespace pal
