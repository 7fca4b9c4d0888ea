#include "language_server/index.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "pal/check/project.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/text_check.hpp"
#include "pal/syntax/parse.hpp"

namespace pal::language_server {

FileId Index::id(const std::string& path) {
  const auto [entry, fresh] = ids_.emplace(path, FileId(paths_.size()));
  if (fresh) paths_.push_back(path);
  return entry->second;
}

const syntax::Tree* Index::tree(const std::string& path) {
  const auto text = workspace_.text(path);
  if (text == nullptr) return nullptr;
  const auto revision = workspace_.revision(path);
  const auto found = parsed_.find(path);
  if (found != parsed_.end() && found->second.revision == revision) return &found->second.tree;
  // Its places are to have the id of this index: texts before it take the smaller ones.
  SourceManager sources;
  const FileId file = id(path);
  while (sources.size() < file.index()) sources.add({}, {});
  sources.add(path, text->content());
  Diagnostics unwanted;
  syntax::Tree tree{file, false, true, {}};
  if (report_unless_text(sources, file, unwanted)) tree = syntax::parse(sources, file, unwanted);
  auto& entry = parsed_[path];
  entry = {revision, std::move(tree)};
  return &entry.tree;
}

const std::vector<std::string>& Index::roots(const std::string& path) {
  if (const auto structure = workspace_.structure(); structure != roots_of_) {
    roots_.clear();
    roots_of_ = structure;
    // What skills_that_see() says of one file after the other, with each skill's files walked once.
    const auto& project = workspace_.project();
    for (const auto& file : project) {
      if (!file.has_skill) continue;
      for (const auto& seen : check::seen_by(project, file.path)) roots_[seen].push_back(file.path);
    }
  }
  auto& roots = roots_[path];
  if (roots.empty()) roots.push_back(path);
  return roots;
}

std::vector<std::string> Index::files_of(const std::string& path) {
  const auto& project = workspace_.project();
  auto roots = check::skills_that_see(project, path);
  for (const auto& file : project) {  // an environment: the skills that it is meant for
    if (!roots.empty() || !file.has_skill) continue;
    const auto near = check::environments_near(project, file.path, workspace_.top(file.path));
    if (std::find(near.begin(), near.end(), path) != near.end()) roots.push_back(file.path);
  }
  std::set<std::string> files{path};
  for (const auto& root : roots) {
    for (auto& each : check::seen_by(project, root)) files.insert(std::move(each));
    for (auto& each : check::environments_near(project, root, workspace_.top(root)))
      files.insert(std::move(each));
  }
  if (roots.empty()) {
    for (auto& each : check::seen_by(project, path)) files.insert(std::move(each));
  }
  return {files.begin(), files.end()};
}

std::shared_ptr<const Family> Index::family(const std::string& path) {
  auto files = files_of(path);
  std::map<std::string, std::uint64_t> revisions;
  for (const auto& file : files) revisions[file] = workspace_.revision(file);
  for (const auto& known : families_) {
    if (known->files == files && known->revisions == revisions) return known;
  }
  auto made = std::make_shared<Family>();
  made->files = std::move(files);
  made->revisions = std::move(revisions);
  for (const auto& file : made->files) {
    const auto* parsed = tree(file);
    if (parsed == nullptr) continue;
    made->trees.push_back(*parsed);
    for (auto& unit : made->trees.back().units) {
      auto* uses = std::get_if<syntax::Uses>(&unit);
      if (uses == nullptr) continue;
      const auto used = resolve_path(file, uses->path);
      if (made->revisions.contains(used)) uses->file = id(used);
    }
  }
  made->symbols = check::symbols_of(made->trees);
  constexpr std::size_t most = 4;
  if (families_.size() == most) families_.erase(families_.begin());
  families_.push_back(made);
  return made;
}

}  // namespace pal::language_server
