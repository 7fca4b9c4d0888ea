// Everything that pal does with a text before there are times: what a fuzzer lets loose on any bytes.
#pragma once

#include <ostream>
#include <sstream>
#include <string>

#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/pan/dot.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/render.hpp"
#include "pal/syntax/print.hpp"

namespace pal::fuzz {

/// Loads and checks `path`; says what is wrong as text and as JSON; prints and draws what is right.
inline void check_whole(const MemoryFileSystem& files, const std::string& path) {
  SourceManager sources;
  Diagnostics diagnostics;
  const auto trees = check::read_sources(files, sources, {path}, diagnostics);
  const auto specification = check::check(trees, diagnostics);
  std::ostringstream out;
  render_text(diagnostics.sorted(), sources, out);
  out << render_json(diagnostics.sorted(), sources);
  for (const auto& tree : trees) {
    syntax::dump(tree, sources, out);
    syntax::print(tree, out);
  }
  for (const auto* networks : {&specification.skills, &specification.sketches}) {
    for (const pan::Network& network : *networks) {
      pan::dump(network, out);
      for (std::size_t i = 0; i < network.modules.size(); ++i) {
        if (!network.modules[i].body.empty()) out << pan::to_dot(network, pan::ModuleId(i));
      }
    }
  }
}

}  // namespace pal::fuzz
