// Changes of a skill's text, and the skill as it is with some of them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/whatif/remedy.hpp"
#include "pal/rewrite/rewrite.hpp"
#include "programs/pal/session/console.hpp"
#include "programs/pal/session/selection.hpp"

namespace pal::program {

/// A change of the text, for people.
struct ProgramChange {
  std::string title;
  std::string module;  // empty: the skill's template
  std::string file;
  int line = 0;
  std::string difference;  // unified, the names of the files included
};

/// The changes that pal/rewrite proposes for one skill. Files are read again and nothing is written.
class ProgramChanges {
 public:
  /// `selection` was read without errors; `skill` is one of its skills. `phases`: by requirement, what it may
  /// be limited to.
  ProgramChanges(const Selection& selection, const pan::Network& skill,
                 const std::map<std::string, std::string>& phases, const FileSystem& files);

  /// By ProgramChangeId.
  const std::vector<ProgramChange>& all() const { return changes_; }

  /// The edits of a change; their files are those of sources().
  const std::vector<Edit>& edits(analyzer::whatif::ProgramChangeId change) const {
    return rewritings_[change.index()].edits;
  }
  const SourceManager& sources() const { return sources_; }

  /// The skill with these changes, or null if they overlap or the changed text has an error. It lives as long
  /// as this object.
  const pan::Network* network_with(const std::vector<analyzer::whatif::ProgramChangeId>& made);

 private:
  void propose(const syntax::Tree& tree, const pan::Network& skill,
               const std::map<std::string, std::string>& phases);
  std::unique_ptr<pan::Network> checked(const std::vector<analyzer::whatif::ProgramChangeId>& made) const;

  const Selection& selection_;
  const FileSystem& files_;
  const std::string skill_;
  SourceManager sources_;
  std::vector<rewrite::Rewriting> rewritings_;  // by ProgramChangeId
  std::vector<ProgramChange> changes_;          // by ProgramChangeId
  std::map<std::vector<analyzer::whatif::ProgramChangeId>, std::unique_ptr<pan::Network>> networks_;
};

}  // namespace pal::program
