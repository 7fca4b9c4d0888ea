#include "language_server/workspace.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "language_server/uri.hpp"

namespace pal::language_server {

namespace {

/// Copies of files stand in folders that tools build in.
bool is_built(const std::string& path, const std::string& folder) {
  return path.find("/build", folder.size()) != std::string::npos;
}

}  // namespace

void Workspace::set_folders(std::vector<std::string> folders) {
  folders_ = std::move(folders);
  for (auto& folder : folders_) {
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  }
  listed_ = false;
  scanned_.clear();
  ++revision_;
  ++structure_;
}

void Workspace::open(const std::string& path, Document document) {
  documents_[path] = std::move(document);
  revisions_[path] = ++revision_;
  scanned_.erase(path);
}

void Workspace::change(const std::string& path, std::int64_t version, std::shared_ptr<const Text> text) {
  auto& document = documents_.at(path);
  document.version = version;
  document.text = std::move(text);
  revisions_[path] = ++revision_;
  scanned_.erase(path);
}

void Workspace::close(const std::string& path) {
  documents_.erase(path);
  reload(path);
}

void Workspace::reload(const std::string& path) {
  read_.erase(path);
  revisions_[path] = ++revision_;
  scanned_.erase(path);
  listed_ = false;
}

const Document* Workspace::find(const std::string& path) const {
  const auto found = documents_.find(path);
  return found == documents_.end() ? nullptr : &found->second;
}

std::uint64_t Workspace::revision(const std::string& path) const {
  const auto found = revisions_.find(path);
  return found == revisions_.end() ? 0 : found->second;
}

void Workspace::scan(const std::string& path) {
  if (scanned_.contains(path)) return;
  const auto content = text(path);
  if (content == nullptr) return;
  auto file = check::project_file(path, content->content());
  const auto uses = file.uses;
  scanned_.emplace(path, std::move(file));
  for (const auto& used : uses) scan(used);
}

const std::vector<check::ProjectFile>& Workspace::project() {
  if (listed_ && project_revision_ == revision_) return project_;
  if (!listed_) {
    std::erase_if(scanned_, [&](const auto& each) {
      return text(each.first) == nullptr;  // it is there no more
    });
    for (const auto& folder : folders_) {
      for (const auto& path : disk_.list(folder, ".pal").value_or(std::vector<std::string>())) {
        if (!is_built(path, folder)) scan(resolve_path({}, path));
      }
    }
    listed_ = true;
  }
  for (const auto& [path, document] : documents_) {
    if (path.ends_with(".pal")) scan(path);
  }
  const auto same = [](const check::ProjectFile& a, const auto& b) {
    return a.path == b.first && a.uses == b.second.uses && a.has_skill == b.second.has_skill &&
           a.has_environment == b.second.has_environment;
  };
  if (structure_ == 0 ||
      !std::equal(project_.begin(), project_.end(), scanned_.begin(), scanned_.end(), same)) {
    project_.clear();
    for (const auto& [path, file] : scanned_) project_.push_back(file);
    ++structure_;
  }
  project_revision_ = revision_;
  return project_;
}

std::string Workspace::top(const std::string& path) const {
  std::string best;
  for (const auto& folder : folders_) {
    if (path.starts_with(folder + "/") && folder.size() > best.size()) best = folder;
  }
  return best.empty() ? std::filesystem::path(path).parent_path().string() : best;
}

std::shared_ptr<const Text> Workspace::text(const std::string& path) const {
  if (const auto* document = find(path)) return document->text;
  const auto [entry, fresh] = read_.try_emplace(path);
  if (fresh) {
    auto content = disk_.read(path);
    if (auto* text = std::get_if<std::string>(&content))
      entry->second = std::make_shared<const Text>(std::move(*text));
  }
  return entry->second;
}

std::string Workspace::uri(const std::string& path) const {
  const auto* document = find(path);
  return document != nullptr ? document->uri : uri_of(path);
}

std::variant<std::string, FileError> Workspace::read(const std::string& path, std::size_t most) const {
  const auto known = text(path);
  if (known == nullptr) return disk_.read(path, most);  // which says why
  if (known->content().size() > most) return FileError{"it is too large"};
  return known->content();
}

std::optional<std::vector<std::string>> Workspace::list(const std::string& path,
                                                        std::string_view ending) const {
  return disk_.list(path, ending);
}

std::string Workspace::identity(const std::string& path) const {
  return disk_.identity(path);
}

}  // namespace pal::language_server
