#include "pal/support/output.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace pal {
namespace {

/// Temporary files that are removed unless they were renamed into place.
class Drafts {
 public:
  ~Drafts() {
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove(path, ignored);
  }
  const std::string& add(const std::string& target) { return paths_.emplace_back(target + ".part"); }

 private:
  std::vector<std::string> paths_;
};

std::optional<std::string> write_draft(const OutputFile& file, Drafts& drafts) {
  const std::filesystem::path path(file.path);
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) return "cannot make the folder " + path.parent_path().string() + ": " + error.message();
  if (std::filesystem::is_directory(path, error)) return "cannot write " + file.path + ": it is a folder";
  const std::string& draft = drafts.add(file.path);
  std::ofstream out(draft, std::ios::binary);
  out.write(file.content.data(), static_cast<std::streamsize>(file.content.size()));
  out.close();
  if (!out) return "cannot write " + file.path + ": is the folder writable and is there space?";
  if (const auto old = std::filesystem::status(path, error); std::filesystem::exists(old)) {
    std::filesystem::permissions(draft, old.permissions(), error);
  }
  return std::nullopt;
}

/// Behind links: the file that is written, not the name by which it is known.
OutputFile behind_links(const OutputFile& file) {
  std::error_code error;
  if (!std::filesystem::is_symlink(file.path, error)) return file;
  const auto target = std::filesystem::canonical(file.path, error);
  return error ? file : OutputFile{target.string(), file.content};
}

}  // namespace

std::optional<std::string> write_files(const std::vector<OutputFile>& named) {
  std::vector<OutputFile> files;
  for (const OutputFile& file : named) files.push_back(behind_links(file));
  Drafts drafts;
  for (const OutputFile& file : files) {
    if (auto problem = write_draft(file, drafts)) return problem;
  }
  for (const OutputFile& file : files) {
    std::error_code error;
    std::filesystem::rename(file.path + ".part", file.path, error);
    if (error) return "cannot write " + file.path + ": " + error.message();
  }
  return std::nullopt;
}

}  // namespace pal
