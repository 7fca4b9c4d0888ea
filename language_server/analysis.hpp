// A file with skills as `pal check` sees it: all that it uses, its environment, its findings.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "language_server/proofs.hpp"
#include "language_server/text.hpp"
#include "language_server/workspace.hpp"
#include "pal/check/check.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::language_server {

struct Analysis {
  std::string root;  // the file with the skills, or one that no skill uses
  SourceManager sources;
  Diagnostics diagnostics;
  check::Specification specification;
  std::vector<std::optional<std::size_t>> environment_of;  // by skill: in specification.environments
  std::map<std::string, std::uint64_t> revisions;          // of all files that were read
  std::vector<std::string> inputs;                         // the files that it began with
  std::vector<std::shared_ptr<const Text>> texts;          // by FileId
  bool ended = false;                                      // by `stop`: not all was checked

  const std::string& path(FileId file) const { return sources.name(file); }
  const Text& text(FileId file) const { return *texts[file.index()]; }
  std::optional<FileId> file(const std::string& path) const { return sources.find(path); }
  const pan::Environment* environment(std::size_t skill) const;
};

/// The files that an analysis of `root` begins with: itself, and those with its environments. `chosen`: files
/// with environments that the user named; empty: by the rule.
std::vector<std::string> inputs_of(Workspace& workspace, const std::string& root,
                                   const std::vector<std::string>& chosen);

/// Whether an analysis of these files would say the same again.
bool is_current(const Analysis& analysis, const Workspace& workspace, const std::vector<std::string>& inputs);

std::shared_ptr<const Analysis> analyze(const Workspace& workspace, std::vector<std::string> inputs,
                                        const std::function<bool()>& stop);

/// Proofs of all skills of an analysis; empty if it has errors. `told` as in Prover::prove(): it gets what is
/// known of the skills up to the one at work.
using Proofs = std::vector<SkillProof>;
Proofs prove(const Analysis& analysis, const Prover& prover, Depth depth, double seconds,
             const std::function<bool()>& stop, const std::function<void(Proofs)>& told = {});

/// Whether another look, with Depth::whole, can say more.
bool is_whole(const Proofs& proofs);

/// Likewise, of all skills.
using AllAdvice = std::vector<Advice>;
AllAdvice advise(const Analysis& analysis, const Prover& prover, double seconds,
                 const std::function<bool()>& stop);

}  // namespace pal::language_server
