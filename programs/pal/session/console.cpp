#include "programs/pal/session/console.hpp"

#include <ostream>
#include <variant>

namespace pal::program {

std::optional<std::string> read_runs(const std::string& path, const Console& console) {
  auto content = console.files.read(path, largest_runs);
  if (auto* text = std::get_if<std::string>(&content)) return std::move(*text);
  console.err << "pal: cannot read '" << path << "': " << std::get<FileError>(content).reason << "\n";
  return std::nullopt;
}

}  // namespace pal::program
