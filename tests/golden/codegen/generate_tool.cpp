// What `pal check` and `pal generate` do of what pal_add_skill asks, where there is no `pal`:
// generate FILE --environment FILE --skill NAME -o DIRECTORY [--depfile FILE --depfile-target NAME]
#include <fstream>
#include <iostream>
#include <map>

#include "codegen/generate.hpp"
#include "pal/check/check.hpp"
#include "pal/check/load.hpp"
#include "pal/support/render.hpp"

namespace {

class Recording final : public pal::FileSystem {
 public:
  std::variant<std::string, pal::FileError> read(const std::string& path) const override {
    names += " " + path;
    return disk_.read(path);
  }
  mutable std::string names;

 private:
  pal::DiskFileSystem disk_;
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  std::map<std::string, std::string> options;
  for (int i = 3; i + 1 < count; i += 2) options[arguments[i]] = arguments[i + 1];
  pal::SourceManager sources;
  pal::Diagnostics diagnostics;
  const Recording files;
  const auto trees = pal::load(files, sources, {arguments[2], options["--environment"]}, diagnostics);
  const auto specification = pal::check(trees, diagnostics);
  for (const auto& network : specification.skills) {
    if (network.skill.name != options["--skill"] || diagnostics.has_errors()) continue;
    const auto generated =
        pal::codegen::generate(network, specification.environments.front(), sources, diagnostics);
    if (std::string(arguments[1]) != "generate") continue;
    for (const auto& file : generated) std::ofstream(options["-o"] + "/" + file.name) << file.text;
  }
  if (options.count("--depfile") != 0) {
    std::ofstream(options["--depfile"]) << options["--depfile-target"] << ":" << files.names << "\n";
  }
  pal::render_text(diagnostics.sorted(), sources, std::cerr);
  return diagnostics.has_errors() ? 1 : 0;
}
