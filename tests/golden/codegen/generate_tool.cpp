// generate_tool SKILL.pal ENVIRONMENT.pal SKILL DIRECTORY: what `pal generate` does, without `pal`.
#include <fstream>
#include <iostream>

#include "codegen/generate.hpp"
#include "pal/check/check.hpp"
#include "pal/check/load.hpp"

int main(int count, char** arguments) {
  if (count != 5) return 2;
  const std::string skill = arguments[3];
  pal::SourceManager sources;
  pal::Diagnostics diagnostics;
  const auto trees = pal::load(pal::DiskFileSystem(), sources, {arguments[1], arguments[2]}, diagnostics);
  const auto specification = pal::check(trees, diagnostics);
  for (const auto& network : specification.skills) {
    if (network.skill.name != skill) continue;
    const auto files =
        pal::codegen::generate(network, specification.environments.front(), sources, diagnostics);
    for (const auto& file : files) std::ofstream(std::string(arguments[4]) + "/" + file.name) << file.text;
  }
  for (const auto& diagnostic : diagnostics.sorted()) std::cerr << diagnostic.message << '\n';
  return diagnostics.has_errors() ? 1 : 0;
}
