// What was proved of earlier texts, for requirements that an edit leaves as they are.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"
#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/source.hpp"

namespace pal::program {

/// What a proof depends on, as text. Two skills of the same key have the same runs, and requirements of the
/// same key ask the same of them: all words of all files are equal, comments and line breaks aside.
struct ProofKey {
  std::string model;                      // without the skill's own requirements
  std::vector<std::string> requirements;  // in the order of Problem::requirements
};
ProofKey key_of(const pan::Network& skill, const pan::Environment& environment,
                const analyzer::Problem& problem, const SourceManager& sources);

/// A verdict that needs no other proof.
struct KeptVerdict {
  analyzer::Verdict verdict;
  bool whole = false;  // its worst run was looked for, too
};

/// Of the last few texts. For several threads.
class KeptProofs {
 public:
  /// By requirement of `problem`, with its lines and places; nothing where it is to be proved.
  std::vector<std::optional<KeptVerdict>> find(const ProofKey& key, const analyzer::Problem& problem);

  enum class Found {
    at_first,    // while the proof goes on
    at_the_end,  // of a proof that looked for no more than verdicts, or had no time to: exact ones are whole
    whole        // all are, as in KeptVerdict
  };
  /// Keeps what is decided; `verdicts` are on the requirements of `problem`.
  void keep(const ProofKey& key, const analyzer::Problem& problem,
            const std::vector<analyzer::Verdict>& verdicts, Found found);

 private:
  struct Model {
    std::string key;
    std::shared_ptr<const analyzer::Problem> problem;
    std::map<std::string, KeptVerdict> verdicts;  // by key of the requirement
  };
  std::list<Model>::iterator model(const std::string& key);

  std::mutex mutex_;
  std::list<Model> models_;  // the last used first
};

}  // namespace pal::program
