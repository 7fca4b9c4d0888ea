// The proofs that the server asks for. The program gives them, with the words that its own reports have.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::language_server {

/// What is known of one requirement.
struct ProvedRequirement {
  std::string name;
  std::string state;  // "holds", "fails", "undecided", "never"
  std::string bound;  // "7.3 ms", "<= 9 ms", "no bound"
  std::string limit;  // "10 ms"
  std::string measure;      // "age of pc-force at TXM( motion to MC1 ) in SM1"
  std::string explanation;  // one paragraph; may be empty
  bool exact = false;       // a run attains the bound
  bool has_run = false;     // there is a worst run to draw
  std::vector<Diagnostic> findings;  // that it fails or is undecided, and why
  SourceSpan cause;         // the statement that most of the time is spent on; invalid: none
};

/// A picture, and what stands at which of its elements.
struct Drawing {
  struct Place {
    std::string id;
    SourceSpan where;
  };
  std::string svg;
  std::vector<Place> places;
};

/// A skill in an environment.
struct SkillProof {
  std::string skill;
  std::string environment;
  std::vector<ProvedRequirement> requirements;  // in the order of the text
  std::vector<Diagnostic> findings;             // about the two together, not about one requirement
  bool ended = false;                           // by its time, or because it was stopped
  /// The worst run of a requirement. Nothing: there is none. It may be called at any time, by one thread.
  std::function<std::optional<Drawing>(std::size_t requirement)> chart;
};

class Prover {
 public:
  virtual ~Prover() = default;

  /// Takes about `seconds` at most. Once `stop` says true it ends soon, and what it gives is not used. All
  /// places are those of `sources`, which `skill` and `environment` come from.
  virtual SkillProof prove(const pan::Network& skill, const pan::Environment& environment,
                           const SourceManager& sources, double seconds,
                           const std::function<bool()>& stop) const = 0;
};

}  // namespace pal::language_server
