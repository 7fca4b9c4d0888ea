#include "codegen/file_names.hpp"

#include <filesystem>

namespace pal::codegen {

std::string file_name(const SourceManager& sources, FileId file, FileId skill) {
  namespace fs = std::filesystem;
  const fs::path name = fs::path(sources.name(file)).lexically_normal();
  fs::path folder = fs::path(sources.name(skill)).lexically_normal().parent_path();
  if (folder.empty()) folder = ".";
  const fs::path result = name.lexically_relative(folder);
  return result.empty() ? name.generic_string() : result.generic_string();  // one is absolute, one is not
}

}  // namespace pal::codegen
