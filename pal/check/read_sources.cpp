#include "pal/check/read_sources.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/support/text_check.hpp"
#include "pal/syntax/parse.hpp"
#include "pal/syntax/parse_dot.hpp"

namespace pal::check {

namespace {

class SourceReader {
 public:
  SourceReader(const FileSystem& files, SourceManager& sources, Diagnostics& diagnostics)
      : files_(files), sources_(sources), diagnostics_(diagnostics) {}

  std::vector<syntax::Tree> read(const std::vector<std::string>& paths) {
    for (const auto& path : paths) open(resolve_path({}, path), {});
    // New files come to the end of the list while it is walked.
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      for (std::size_t k = 0; k < trees_[i].units.size(); ++k) {
        auto* uses = std::get_if<syntax::Uses>(&trees_[i].units[k]);
        if (uses == nullptr) continue;
        const auto path = resolve_path(sources_.name(trees_[i].file), uses->path);
        const auto where = uses->where;
        const auto file = open(path, where);
        if (file) std::get<syntax::Uses>(trees_[i].units[k]).file = *file;
      }
    }
    report_circles();
    return std::move(trees_);
  }

 private:
  std::optional<FileId> open(const std::string& path, SourceSpan named_at) {
    const std::string identity = files_.identity(path);
    if (const auto known = opened_.find(identity); known != opened_.end()) return known->second;
    auto& entry = opened_[identity];
    auto read = files_.read(path);
    if (const auto* error = std::get_if<FileError>(&read)) {
      const bool by_uses = named_at.valid();
      diagnostics_.report(either<Finding::used_file_cannot_be_read, Finding::file_cannot_be_read>(by_uses),
                          by_uses ? named_at : SourceSpan{sources_.add(path, {}), 0, 0}, path, error->reason);
      return std::nullopt;
    }
    const auto file = sources_.add(path, std::get<std::string>(std::move(read)));
    entry = file;
    if (report_unless_text(sources_, file, diagnostics_)) {
      const bool drawn = path.ends_with(".dot") || path.ends_with(".gv");
      trees_.push_back(drawn ? syntax::parse_dot(sources_, file, diagnostics_)
                             : syntax::parse(sources_, file, diagnostics_));
    } else {
      trees_.push_back({file, false, true, {}});
    }
    return file;
  }

  void report_circles() {
    std::map<FileId, std::size_t> index;
    for (std::size_t i = 0; i < trees_.size(); ++i) index[trees_[i].file] = i;
    enum class Mark { fresh, open, done };
    std::vector<Mark> marks(trees_.size(), Mark::fresh);
    struct Step {
      std::size_t tree;
      std::size_t unit;
    };
    for (std::size_t root = 0; root < trees_.size(); ++root) {
      if (marks[root] != Mark::fresh) continue;
      std::vector<Step> path{{root, 0}};
      marks[root] = Mark::open;
      while (!path.empty()) {
        auto& step = path.back();
        if (step.unit == trees_[step.tree].units.size()) {
          marks[step.tree] = Mark::done;
          path.pop_back();
          continue;
        }
        const auto* uses = std::get_if<syntax::Uses>(&trees_[step.tree].units[step.unit++]);
        if (uses == nullptr || !uses->file.valid()) continue;
        const auto next = index.at(uses->file);
        if (marks[next] == Mark::open) {
          auto& finding = diagnostics_.report(Finding::circle_of_files, uses->where);
          const auto first =
              std::find_if(path.begin(), path.end(), [&](const Step& s) { return s.tree == next; });
          for (auto at = first; at + 1 < path.end(); ++at) {
            const auto& through = std::get<syntax::Uses>(trees_[at->tree].units[at->unit - 1]);
            finding.note(through.where, Remark::used_by_way_of);
          }
        } else if (marks[next] == Mark::fresh) {
          marks[next] = Mark::open;
          path.push_back({next, 0});
        }
      }
    }
  }

  const FileSystem& files_;
  SourceManager& sources_;
  Diagnostics& diagnostics_;
  std::vector<syntax::Tree> trees_;
  std::map<std::string, std::optional<FileId>> opened_;  // by identity
};

}  // namespace

std::vector<syntax::Tree> read_sources(const FileSystem& files, SourceManager& sources,
                                       const std::vector<std::string>& paths, Diagnostics& diagnostics) {
  return SourceReader(files, sources, diagnostics).read(paths);
}

}  // namespace pal::check
