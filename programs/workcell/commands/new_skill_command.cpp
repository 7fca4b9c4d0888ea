// workcell new-skill: a folder with a skill of one's own, which builds, is proved and runs.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <regex>
#include <sstream>

#include "codegen/generate.hpp"
#include "pal/support/output.hpp"
#include "programs/pal/session/selection.hpp"
#include "programs/workcell/options/command_line.hpp"

namespace pal::workcell {
namespace {

namespace fs = std::filesystem;

/// The name in C++: hyphens become underscores.
std::string in_code(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

void check_name(const std::string& name) {
  static const std::regex form("[a-z][a-z0-9]*(-[a-z0-9]+)*");
  if (!std::regex_match(name, form))
    throw Failure(ExitStatus::usage, "new-skill " + name, "this is no name for a skill",
                  "write small letters, digits and hyphens: tap, or press-twice");
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Failure(ExitStatus::usage, file.string(), "it cannot be read", "check the path");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  return std::regex_replace(text, std::regex(what), by);
}

std::string cmake_file(const std::string& name, const std::vector<std::string>& sources, bool declares) {
  std::string all;
  for (const std::string& source : sources) all += " " + source;
  return fmt::format(
      R"(# The skill {0}: cmake -S . -B build && cmake --build build && workcell run build/{1}.so
cmake_minimum_required(VERSION 3.25)
project({1} LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_package(pal 0.1 REQUIRED COMPONENTS workcell)

# Stops the build if a requirement of {1}.pal does not hold in workcell.pal.
pal_add_skill({1} SKILL {0} PAL {1}.pal ENVIRONMENT workcell.pal SOURCES{2} WORKCELL{3})
target_link_libraries(pal_skill_{1} PUBLIC pal::skill_modules)
)",
      name, in_code(name), all, declares ? " DECLARED " + in_code(name) + ".declared" : "");
}

/// Where a text of the workcell's skills stands in the new folder: its own skill's beside the others'
/// folders.
std::string place(const std::string& name, const std::string& folder) {
  if (name.starts_with(folder + "/")) return name.substr(folder.size() + 1);
  const std::string parent = fs::path(folder).parent_path().string();
  return parent.empty() || !name.starts_with(parent + "/") ? name : name.substr(parent.size() + 1);
}

/// All of a skill that is there, under another name.
class Likeness {
 public:
  Likeness(const KnownSkill& known, std::string name, const std::string& skill_folder)
      : known_(known),
        name_(std::move(name)),
        folder_(fs::path(known.pal_file).parent_path().string()),
        cpp_folder_(fs::path(skill_folder) / fs::path(folder_).filename()) {
    std::error_code ignored;
    if (folder_.empty() || !fs::is_directory(cpp_folder_, ignored))
      throw Failure(ExitStatus::wrong_specification, "--like " + known.name,
                    "its activities are not installed with the workcell",
                    "copy its folder by hand, or name one of the workcell's own skills");
  }

  std::vector<OutputFile> files(const std::vector<KnownSkill>& all) {
    std::vector<OutputFile> result;
    const std::string top = fs::path(folder_).begin()->string();
    const auto texts = known_.texts->list(top, ".pal").value_or(std::vector<std::string>{});
    for (const std::string& text : texts) result.push_back(pal(text));
    std::vector<std::string> sources;
    for (const auto& entry : fs::directory_iterator(cpp_folder_)) {
      const std::string extension = entry.path().extension(), stem = entry.path().stem();
      const bool header = extension == ".hpp", other = is_of_another(stem, all);
      if ((extension != ".cpp" && !header) || other || (header && stem == in_code(known_.name))) continue;
      const std::string file = (stem == in_code(known_.name) ? in_code(name_) : stem) + extension;
      if (!header) sources.push_back(file);
      result.push_back({file, cpp(text_of(entry.path()))});
    }
    std::sort(sources.begin(), sources.end());
    const bool declares = !known_.declared_file.empty();
    if (declares)
      result.push_back(
          {in_code(name_) + ".declared", std::get<std::string>(known_.texts->read(known_.declared_file))});
    result.push_back({"CMakeLists.txt", cmake_file(name_, sources, declares)});
    return result;
  }

 private:
  bool is_of_another(const std::string& stem, const std::vector<KnownSkill>& all) const {
    return std::any_of(all.begin(), all.end(), [&](const KnownSkill& each) {
      return each.name != known_.name && in_code(each.name) == stem;
    });
  }

  OutputFile pal(const std::string& path) const {
    std::string text = std::get<std::string>(known_.texts->read(path));
    std::string file = place(path, folder_);
    if (path.starts_with(folder_ + "/")) text = replaced(text, "USES \"\\.\\./", "USES \"");
    if (path == known_.pal_file) {
      file = in_code(name_) + ".pal";
      text = replaced(text, "(^|\n)SKILL " + known_.name + "(\r?\n)", "$1SKILL " + name_ + "$2");
    }
    return {file, text};
  }

  std::string cpp(std::string text) const {
    const std::string was = in_code(known_.name), is = in_code(name_);
    text = replaced(text, "#include \"skills_pal/[a-z_]*/" + was + "\\.hpp\"\n\n?", "");
    text =
        replaced(text, "#include \"skills_pal/" + fs::path(folder_).filename().string() + "/", "#include \"");
    text = replaced(text, "\\b" + was + "::", is + "::");
    text = replaced(text, "\\bnamespace " + was + "\\b", "namespace " + is);
    text = replaced(text, "\\bmake_" + was + "\\b", "make_" + is);
    return replaced(text, "\\b" + was + "_(skill|activities|messages|parameters|devices)\\b", is + "_$1");
  }

  const KnownSkill& known_;
  std::string name_, folder_;
  fs::path cpp_folder_;
};

/// A PAL file and the workcell's environment, with activities that do nothing yet.
std::vector<OutputFile> from_pal(const NewSkillCommand& command) {
  const fs::path given(command.from);
  DiskFileSystem files;
  std::ostringstream out, error;
  program::Session session;
  program::Selection selection;
  selection.files = {command.from};
  selection.environments = {command.skill_folder + "/workcell.pal"};
  selection.environment = "workcell";
  const bool chosen = program::read(selection, {out, error, files}, session);
  program::show_findings(session, {out, error, files});
  if (session.diagnostics.has_errors())
    throw Failure(ExitStatus::wrong_specification, command.from, "it has errors\n" + error.str(),
                  "pal check shows all of them");
  if (!chosen || session.specification.skills.size() != 1)
    throw Failure(ExitStatus::wrong_specification, command.from, "it is not one skill\n" + error.str(),
                  "choose a file with one SKILL");
  const auto plan =
      codegen::make_plan(session.specification.skills.front(), session.specification.environments.front(),
                         session.sources, session.diagnostics);
  if (!plan) {
    program::show_findings(session, {out, error, files});
    throw Failure(ExitStatus::wrong_specification, command.from,
                  "it cannot run in the workcell\n" + error.str(), "");
  }
  const std::string name = in_code(command.name);
  if (plan->skill.name != command.name)
    throw Failure(ExitStatus::usage, "new-skill " + command.name,
                  "the skill of " + command.from + " is called " + plan->skill.name,
                  "write workcell new-skill " + plan->skill.name);
  std::vector<OutputFile> result;
  for (std::size_t i = 0; i < session.sources.size(); ++i) {
    const std::string& path = session.sources.name(FileId(i));
    const std::string folder = given.parent_path().string();
    std::string file = fs::path(path).lexically_relative(folder.empty() ? "." : folder).string();
    if (path == command.from) file = name + ".pal";
    if (path == selection.environments.front()) file = "workcell.pal";
    if (file.empty() || file.starts_with(".."))
      throw Failure(ExitStatus::usage, path, "it is not in the folder of " + command.from + ", or below",
                    "copy it there: the new folder has all that the skill needs");
    result.push_back({file, std::string(session.sources.text(FileId(i)))});
  }
  result.push_back({name + ".cpp", codegen::emit_empty_activities(*plan).text});
  const std::string declared = fs::path(given).replace_extension(".declared").string();
  std::error_code none;
  const bool declares = fs::is_regular_file(declared, none);
  if (declares) result.push_back({name + ".declared", text_of(declared)});
  result.push_back({"CMakeLists.txt", cmake_file(command.name, {name + ".cpp"}, declares)});
  return result;
}

}  // namespace

ExitStatus new_skill(const NewSkillCommand& command, const std::vector<KnownSkill>& skills,
                     std::ostream& out) {
  check_name(command.name);
  if (command.like.empty() == command.from.empty())
    throw Failure(ExitStatus::usage, "new-skill " + command.name, "it is not said what the skill begins as",
                  "write --like touch, for a copy of a skill, or --from tap.pal, for empty activities");
  const std::string folder = command.output.empty() ? in_code(command.name) : command.output;
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored))
    throw Failure(ExitStatus::usage, folder, "it is there already, and not empty",
                  "choose another folder by --output");
  std::vector<OutputFile> files;
  if (!command.from.empty()) {
    files = from_pal(command);
  } else {
    const auto known = std::find_if(skills.begin(), skills.end(),
                                    [&](const KnownSkill& each) { return each.name == command.like; });
    if (known == skills.end() || !known->texts)
      throw Failure(ExitStatus::wrong_specification, "--like " + command.like, "there is no such skill",
                    "workcell list shows the skills that there are");
    files = Likeness(*known, command.name, command.skill_folder).files(skills);
  }
  for (OutputFile& file : files) file.path = folder + "/" + file.path;
  if (const auto problem = write_files(files))
    throw Failure(ExitStatus::usage, folder, *problem, "choose another folder by --output");
  for (const OutputFile& file : files) out << file.path << '\n';
  out << fmt::format(
      "build, prove and run it:\n  cmake -S {0} -B {0}/build && cmake --build {0}/build\n"
      "  workcell run {0}/build/{1}.so\n",
      folder, in_code(command.name));
  return ExitStatus::done;
}

}  // namespace pal::workcell
