#include "programs/pal/session/changed_since.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "programs/pal/session/process.hpp"

namespace pal::program {
namespace {

namespace fs = std::filesystem;

std::string real_path(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? path : real.string();
}

/// What git says in the folder, or nothing.
std::optional<std::string> git(const std::string& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"-C", folder});
  Spoken spoken = run_and_read("git", std::move(words));
  return spoken.status == 0 ? std::optional(std::move(spoken.out)) : std::nullopt;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// Of a list with a zero behind each name.
std::set<std::string> names_in(const std::string& list) {
  std::set<std::string> names;
  for (std::size_t from = 0; from < list.size();) {
    const auto end = std::min(list.find('\0', from), list.size());
    names.insert(list.substr(from, end - from));
    from = end + 1;
  }
  return names;
}

/// A work tree, and what differs there from the revision.
class WorkTree {
 public:
  /// What went wrong, or nothing.
  std::optional<std::string> open(const std::string& revision, const std::string& some_file) {
    const std::string folder = fs::path(some_file).parent_path().string();
    const auto top = git(folder, {"rev-parse", "--show-toplevel"});
    if (!top) return "--changed-since needs git, and '" + some_file + "' in a work tree of it";
    top_ = real_path(first_line(*top));
    const auto commit =
        git(top_, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
    if (!commit)
      return "git knows no revision '" + revision + "' in " + top_ +
             "; a shallow clone has not all: git fetch --unshallow, or a greater fetch-depth";
    const auto known = git(top_, {"ls-files", "-z"});
    const auto changed =
        git(top_, {"diff", "--name-only", "-z", "--no-renames", "--no-ext-diff", first_line(*commit), "--"});
    if (!known || !changed) return "git could not compare the files with '" + revision + "'";
    known_ = names_in(*known);
    changed_ = names_in(*changed);
    return std::nullopt;
  }

  bool is_unchanged(const std::string& file) const {
    const std::string path = real_path(file);
    if (!path.starts_with(top_ + "/")) return false;
    const std::string name = path.substr(top_.size() + 1);
    return known_.contains(name) && !changed_.contains(name);
  }

 private:
  std::string top_;
  std::set<std::string> known_;
  std::set<std::string> changed_;
};

std::set<FileId> files_of(const pan::Network& skill, const pan::Environment& environment,
                          const Session& session) {
  std::set<FileId> files{skill.skill.where.file, environment.where.file};
  const auto seen = session.specification.seen.find(skill.skill.where.file);
  if (seen != session.specification.seen.end()) files.insert(seen->second.begin(), seen->second.end());
  return files;
}

}  // namespace

std::variant<std::vector<LeftOut>, std::string> unchanged_since(const std::string& revision,
                                                                const Session& session) {
  std::vector<LeftOut> left_out;
  if (session.sources.size() == 0) return left_out;
  WorkTree tree;
  if (const auto wrong = tree.open(revision, real_path(session.sources.name(FileId(0))))) return *wrong;
  for (const pan::Network& skill : session.specification.skills) {
    for (const pan::Environment& environment : session.specification.environments) {
      const std::set<FileId> files = files_of(skill, environment, session);
      const bool same = std::all_of(files.begin(), files.end(), [&](FileId file) {
        return tree.is_unchanged(session.sources.name(file));
      });
      if (same)
        left_out.push_back(
            {&skill, &environment,
             "none of its " + std::to_string(files.size()) + " files has changed since " + revision});
    }
  }
  return left_out;
}

void mark_left_out(const std::vector<LeftOut>& left_out, std::vector<Unchecked>& not_checked) {
  for (Unchecked& row : not_checked) {
    const auto found = std::find_if(left_out.begin(), left_out.end(), [&row](const LeftOut& each) {
      return each.skill->skill.name == row.skill && each.environment->name == row.environment;
    });
    if (found == left_out.end()) continue;
    row.left_out = true;
    row.reason = found->reason;
    row.hint = "check it without --changed-since";
  }
}

}  // namespace pal::program
