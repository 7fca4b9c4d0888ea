#include "pal/check/project.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "pal/check/resources.hpp"
#include "pal/support/file_system.hpp"
#include "pal/syntax/text_tokens.hpp"

namespace pal::check {

namespace {

std::string capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string folder_of(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

}  // namespace

ProjectFile project_file(const std::string& path, std::string_view text) {
  ProjectFile file{path, {}, false, false};
  std::string before, last;  // the two words before
  for (const auto& token : syntax::text_tokens(text)) {
    using Kind = syntax::TextToken::Kind;
    if (token.kind == Kind::comment) continue;
    const auto written = text.substr(token.begin, token.end - token.begin);
    if (token.kind == Kind::text && last == "USES" && written.size() >= 2)
      file.uses.push_back(resolve_path(path, std::string(written.substr(1, written.size() - 2))));
    const std::string word = capitals(written);
    // SKILL name: not END SKILL, GENERIC SKILL, Skill Module or SKILL METHOD.
    const bool begins = before != "END" && before != "GENERIC";
    if (last == "SKILL" && begins && word != "METHOD" && word != "MODULE") file.has_skill = true;
    if (last == "ENVIRONMENT" && begins) file.has_environment = true;
    before = std::move(last);
    last = word;
  }
  return file;
}

std::vector<std::string> seen_by(const std::vector<ProjectFile>& files, const std::string& path) {
  std::map<std::string, const ProjectFile*> by_path;
  for (const auto& file : files) by_path.emplace(file.path, &file);
  std::vector<std::string> order{path};
  std::set<std::string> seen{path};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto found = by_path.find(order[i]);
    if (found == by_path.end()) continue;
    for (const auto& used : found->second->uses) {
      if (by_path.contains(used) && seen.insert(used).second) order.push_back(used);
    }
  }
  return order;
}

std::vector<std::string> skills_that_see(const std::vector<ProjectFile>& files, const std::string& path) {
  std::map<std::string, std::vector<const ProjectFile*>> users;
  for (const auto& file : files) {
    for (const auto& used : file.uses) users[used].push_back(&file);
  }
  std::set<std::string> above{path};
  std::vector<std::string> open{path};
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    for (const auto* user : users[next]) {
      if (above.insert(user->path).second) open.push_back(user->path);
    }
  }
  std::vector<std::string> result;
  for (const auto& file : files) {
    if (file.has_skill && above.contains(file.path)) result.push_back(file.path);
  }
  return result;
}

std::vector<std::string> environments_near(const std::vector<ProjectFile>& files, const std::string& skill,
                                           const std::string& top) {
  const auto has_environment = [&](const std::string& path) {
    return std::any_of(files.begin(), files.end(),
                       [&](const auto& file) { return file.path == path && file.has_environment; });
  };
  const auto own = seen_by(files, skill);
  if (std::any_of(own.begin(), own.end(), has_environment)) return {};
  for (std::string folder = folder_of(skill);; folder = folder_of(folder)) {
    std::vector<std::string> found;
    for (const auto& file : files) {
      // A file with a skill has its environment for that one.
      if (file.has_environment && !file.has_skill && folder_of(file.path) == folder) found.push_back(file.path);
    }
    std::sort(found.begin(), found.end());
    if (!found.empty() || folder == top || folder == folder_of(folder)) return found;
  }
}

std::optional<std::size_t> fitting_environment(const pan::Network& skill,
                                               const std::vector<pan::Environment>& environments) {
  if (environments.empty()) return std::nullopt;
  const auto needed = needed_resources(skill);
  for (std::size_t i = 0; i < environments.size(); ++i) {
    if (missing_resources(needed, environments[i]).empty()) return i;
  }
  return 0;
}

}  // namespace pal::check
