// Names across files: the files that belong together, their trees, and the table of their names.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "language_server/workspace.hpp"
#include "pal/check/symbols.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::language_server {

/// Files that one file is looked at with: the skills that see it, what these see, their environments.
struct Family {
  std::vector<std::string> files;
  std::map<std::string, std::uint64_t> revisions;
  std::vector<syntax::Tree> trees;
  check::Symbols symbols;
};

/// For one thread. File ids are those of this index.
class Index {
 public:
  explicit Index(Workspace& workspace) : workspace_(workspace) {}

  FileId id(const std::string& path);
  const std::string& path(FileId file) const { return paths_[file.index()]; }

  /// The tree of one file, also of one with errors; nullptr if it cannot be read.
  const syntax::Tree* tree(const std::string& path);

  std::shared_ptr<const Family> family(const std::string& path);

  /// The files with skills by which `path` is looked at; itself if there are none.
  const std::vector<std::string>& roots(const std::string& path);

 private:
  struct Parsed {
    std::uint64_t revision = 0;
    syntax::Tree tree;
  };
  std::vector<std::string> files_of(const std::string& path);

  Workspace& workspace_;
  std::vector<std::string> paths_;
  std::map<std::string, FileId> ids_;
  std::map<std::string, Parsed> parsed_;
  std::vector<std::shared_ptr<const Family>> families_;  // the last ones
  std::map<std::string, std::vector<std::string>> roots_;
  std::uint64_t roots_of_ = 0;  // the structure of the workspace that they are of
};

}  // namespace pal::language_server
