// A specification from strings, for tests.
#pragma once

#include <string>
#include <vector>

#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/file_system.hpp"

namespace pal::test {

struct Checked {
  SourceManager sources;
  Diagnostics diagnostics;
  std::vector<syntax::Tree> trees;
  check::Specification specification;
};

/// Loads and checks the files named first, from `files`.
inline Checked check_files(const FileSystem& files, const std::vector<std::string>& paths) {
  Checked result;
  result.trees = check::read_sources(files, result.sources, paths, result.diagnostics);
  result.specification = pal::check::check(result.trees, result.diagnostics);
  return result;
}

inline Checked check_text(const std::string& text) {
  MemoryFileSystem files;
  files.add("a.pal", text);
  return check_files(files, {"a.pal"});
}

inline std::string source_file(const std::string& path) {
  return std::get<std::string>(DiskFileSystem().read(std::string(PAL_SOURCE_DIR "/") + path));
}

}  // namespace pal::test
