// Skills in tests of the search for deadlocks: from PAL text to the network, dead ends and all.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::test {

/// The one skill of the text. Empty if anything is wrong with it but that it stops or waits for ever.
inline std::optional<pan::Network> talking_skill(const std::string& text) {
  MemoryFileSystem files;
  files.add("talk.pal", text);
  SourceManager sources;
  Diagnostics diagnostics;
  auto specification =
      check::check(check::read_sources(files, sources, {"talk.pal"}, diagnostics), diagnostics);
  for (const auto& finding : diagnostics.all()) {
    const bool dead_end = finding.code == Code::PAL0521 || finding.code == Code::PAL0522;
    if (finding.severity == Severity::error && !dead_end) return std::nullopt;
  }
  if (specification.skills.size() != 1) throw std::runtime_error("not one skill");
  return std::move(specification.skills.front());
}

}  // namespace pal::test
