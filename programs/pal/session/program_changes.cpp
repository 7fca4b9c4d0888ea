#include "programs/pal/session/program_changes.hpp"

#include <algorithm>
#include <cassert>

#include "pal/check/read_sources.hpp"
#include "pal/support/edit.hpp"
#include "pal/support/line_difference.hpp"

namespace pal::program {
namespace {

/// Files of which some have another text.
class EditedFiles : public FileSystem {
 public:
  EditedFiles(const FileSystem& files, std::map<std::string, std::string> edited)
      : files_(files), edited_(std::move(edited)) {}

  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override {
    const auto found = edited_.find(path);
    return found == edited_.end() ? files_.read(path, most) : found->second;
  }
  std::string identity(const std::string& path) const override { return files_.identity(path); }

 private:
  const FileSystem& files_;
  std::map<std::string, std::string> edited_;
};

std::vector<std::string> paths_of(const Selection& selection) {
  std::vector<std::string> paths = selection.files;
  paths.insert(paths.end(), selection.environments.begin(), selection.environments.end());
  return paths;
}

bool has_module(const pan::Network& skill, const std::string& name) {
  return std::any_of(skill.modules.begin(), skill.modules.end(),
                     [&](const pan::Module& module) { return module.name == name; });
}

bool overlap(const std::vector<Edit>& edits) {
  for (std::size_t a = 0; a < edits.size(); ++a) {
    for (std::size_t b = a + 1; b < edits.size(); ++b) {
      const SourceSpan& one = edits[a].where;
      const SourceSpan& other = edits[b].where;
      if (one.file != other.file) continue;
      const bool apart = one.end <= other.begin || other.end <= one.begin;
      // Two insertions at one place have no order.
      if (!apart || (one.begin == other.begin && one.begin == one.end && other.begin == other.end))
        return true;
    }
  }
  return false;
}

}  // namespace

ProgramChanges::ProgramChanges(const Selection& selection, const pan::Network& skill,
                               const std::map<std::string, std::string>& phases, const FileSystem& files)
    : selection_(selection), files_(files), skill_(skill.skill.name) {
  Diagnostics ignored;
  for (const syntax::Tree& tree : check::read_sources(files, sources_, paths_of(selection), ignored)) {
    if (tree.complete) propose(tree, skill, phases);
  }
}

void ProgramChanges::propose(const syntax::Tree& tree, const pan::Network& skill,
                             const std::map<std::string, std::string>& phases) {
  const std::string_view text = sources_.text(tree.file);
  std::vector<rewrite::Rewriting> proposed = rewrite::read_after_wait(tree, text);
  for (auto& more : {rewrite::set_after_wait(tree, text), rewrite::ask_ahead(tree, text),
                     rewrite::limit_to_phase(tree, skill_, phases)})
    proposed.insert(proposed.end(), more.begin(), more.end());
  for (rewrite::Rewriting& each : proposed) {
    if ((!each.module.empty() && !has_module(skill, each.module)) || overlap(each.edits)) continue;
    const std::string& file = sources_.name(tree.file);
    changes_.push_back(
        {each.title, each.module, file, sources_.line_column(tree.file, each.where.begin).line,
         line_difference(file, text, file + " (changed)", apply(each.edits, tree.file, text))});
    rewritings_.push_back(std::move(each));
  }
}

const pan::Network* ProgramChanges::network_with(const std::vector<analyzer::whatif::ProgramChangeId>& made) {
  auto key = made;
  std::sort(key.begin(), key.end());
  const auto [found, is_new] = networks_.try_emplace(key);
  if (is_new) found->second = checked(key);
  return found->second.get();
}

std::unique_ptr<pan::Network> ProgramChanges::checked(
    const std::vector<analyzer::whatif::ProgramChangeId>& made) const {
  std::vector<Edit> edits;
  for (const analyzer::whatif::ProgramChangeId id : made) {
    assert(id.valid() && id.index() < rewritings_.size());
    const auto& more = rewritings_[id.index()].edits;
    edits.insert(edits.end(), more.begin(), more.end());
  }
  if (overlap(edits)) return nullptr;
  std::map<std::string, std::string> edited;
  for (const Edit& edit : edits) {
    const FileId file = edit.where.file;
    edited.try_emplace(sources_.name(file), apply(edits, file, sources_.text(file)));
  }
  const EditedFiles files(files_, std::move(edited));
  SourceManager sources;
  Diagnostics diagnostics;
  check::Specification specification =
      check::check(check::read_sources(files, sources, paths_of(selection_), diagnostics), diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  for (pan::Network& skill : specification.skills) {
    if (skill.skill.name == skill_) return std::make_unique<pan::Network>(std::move(skill));
  }
  return nullptr;
}

}  // namespace pal::program
