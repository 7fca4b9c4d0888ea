// A skill in a file of its own (a shared library), which a host such as the workcell loads when it starts.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pal/runtime/interface.hpp"
#include "pal/runtime/skill.hpp"

namespace pal::runtime {

/// A text that the skill was generated from.
struct SourceText {
  std::string_view name;  // as pal was told: "skills_pal/touch/touch.pal"
  std::string_view text;
};

/// All that a host knows of a plug-in. Generated code hands it out by the C function `pal_skill`.
struct SkillPlugin {
  const char* interface;  // plugin_interface of the headers it was built with; first, whatever the version
  std::string_view name;  // as in PAL
  std::unique_ptr<Skill> (*make)();
  std::string_view folder;    // where it was built: names of texts are relative to it; empty: not told
  std::string_view pal_file;  // in `sources`, like the next
  std::string_view environment_file;
  std::string_view declared_file;       // what the skill declares to the cell; empty: nothing
  std::span<const SourceText> sources;  // all texts that were read: what is proved is what was compiled
};

/// The name of that function.
constexpr const char* plugin_function = "pal_skill";

/// A file is no plug-in, or none for this host. what() says why, hint() what to do.
class PluginError : public std::runtime_error {
 public:
  PluginError(const std::string& cause, std::string hint)
      : std::runtime_error(cause), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Loads the file; it stays loaded as long as the process runs. Throws PluginError.
const SkillPlugin& load_plugin(const std::string& path);

/// Those of all files NAME.so in the folder, in the order of the skills' names. Throws PluginError, which
/// names the file; a folder that is not there has none.
std::vector<const SkillPlugin*> load_plugins(const std::string& folder);

}  // namespace pal::runtime
