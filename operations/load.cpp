#include "operations/load.hpp"

#include <set>

#include "operations/parse.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::operations {
namespace {

struct Wanted {
  std::string path;
  SourceSpan where;
};

}  // namespace

std::optional<Program> load(const FileSystem& files, SourceManager& sources, const std::string& path,
                            Diagnostics& diagnostics) {
  Program program;
  std::set<std::string> seen{path};
  std::vector<Wanted> wanted{{path, {}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Wanted next = wanted[i];
    auto content = files.read(next.path);
    if (const auto* error = std::get_if<FileError>(&content)) {
      const SourceSpan where = next.where.valid() ? next.where : SourceSpan{sources.add(next.path, {}), 0, 0};
      diagnostics.report(Code::PAL0111, where, "cannot read '" + next.path + "': " + error->reason,
                         "check the name and whether the file may be read");
      continue;
    }
    const FileId file = sources.add(next.path, std::get<std::string>(content));
    auto document = parse(sources, file, diagnostics);
    if (!document) continue;
    for (Operation& operation : document->operations) {
      for (const Icon& icon : operation.icons) {
        if (icon.file.empty()) continue;
        const std::string named = resolve_path(next.path, icon.file);
        if (seen.insert(named).second) wanted.push_back({named, icon.subject});
      }
      program.operations.push_back(std::move(operation));
    }
  }
  if (program.operations.empty() || program.operations.front().from != path) return std::nullopt;
  return program;
}

}  // namespace pal::operations
