#include "operations/load.hpp"

#include <set>

#include "operations/parse.hpp"
#include "pal/support/finding.hpp"

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
      diagnostics.report(Finding::operation_cannot_be_read, where, next.path, error->reason);
      continue;
    }
    const FileId file = sources.add(next.path, std::get<std::string>(content));
    auto document = parse(sources, file, diagnostics);
    if (!document) continue;
    for (Operation& operation : document->operations) {
      const auto want = [&](const std::string& name, SourceSpan where) {
        if (name.empty()) return;
        const std::string named = resolve_path(next.path, name);
        if (seen.insert(named).second) wanted.push_back({named, where});
      };
      for (const Icon& icon : operation.icons) want(icon.file, icon.subject);
      want(operation.on_stop.file, operation.on_stop.where);
      program.operations.push_back(std::move(operation));
    }
    program.extents.insert(program.extents.end(), document->extents.begin(), document->extents.end());
  }
  if (program.operations.empty() || program.operations.front().from != path) return std::nullopt;
  return program;
}

}  // namespace pal::operations
