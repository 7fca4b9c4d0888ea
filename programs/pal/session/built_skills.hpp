// Skills that were built as files, with the PAL that lies in them. The program `workcell` tells it: this program does
// not run what others have compiled.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/file_system.hpp"
#include "programs/pal/session/selection.hpp"

namespace pal::program {

struct BuiltSkill {
  std::string name;
  std::string pal, environment;              // paths of its texts: the built file, and the text's own name
  std::map<std::string, std::string> texts;  // by path
};

/// The disk, and the texts of built skills.
class BuiltSkills final : public FileSystem {
 public:
  /// The disk outlives it.
  explicit BuiltSkills(const FileSystem& disk) : disk_(disk) {}

  /// Adds their PAL to the files of skills and of environments that are read.
  void add(std::vector<BuiltSkill> built, std::vector<std::string>& skills,
           std::vector<std::string>& environments);

  /// Whether the skill runs with these times. A built skill is proved in the environment that lies in its file,
  /// and no other skill is.
  bool runs_in(const pan::Network& skill, const pan::Environment& environment, const Session& session) const;
  /// A built skill takes the place of another one of its name.
  bool take_the_place_of(const pan::Network& skill, const Session& session) const;

  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override;
  std::optional<std::vector<std::string>> list(const std::string& path,
                                               std::string_view ending) const override;
  std::string identity(const std::string& path) const override;

 private:
  const std::string* text_of(const std::string& path) const;

  const FileSystem& disk_;
  std::vector<BuiltSkill> built_;
};

/// Takes the files of built skills out of `skills`.
std::vector<std::string> take_built(std::vector<std::string>& skills);

}  // namespace pal::program
