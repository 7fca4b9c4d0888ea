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

/// A part of the worst run, at the statement that it is spent on.
struct Share {
  SourceSpan where;
  std::string amount;  // "27.15 ms"
  std::string what;    // "SM1 waits at WTM( motion request from MC1 )"
};

/// What is known of one requirement.
struct ProvedRequirement {
  std::string name;
  std::string state;                 // "holds", "fails", "undecided", "never"; "open": its proof goes on
  std::string bound;                 // "7.3 ms", "<= 9 ms", "no bound"; of what is open perhaps ""
  std::string limit;                 // "10 ms"
  std::string measure;               // "age of pc-force at TXM( motion to MC1 ) in SM1"
  std::string explanation;           // one paragraph; may be empty
  bool exact = false;                // a run attains the bound
  bool has_run = false;              // there is a worst run to draw
  std::vector<Diagnostic> findings;  // that it fails or is undecided, and why
  SourceSpan cause;                  // the statement that most of the time is spent on; invalid: none
  std::string cause_text;     // "27.15 ms of 35.35 ms: SM1 waits at WTM( … )"; empty: there is no cause
  std::vector<Share> shares;  // of the worst run, in its order; a statement may come more than once
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
  /// The worst run of a requirement; `narrow`: for half a page. Nothing: there is none. It may be called at
  /// any time, by one thread.
  std::function<std::optional<Drawing>(std::size_t requirement, bool narrow)> chart;
};

/// By how much a time of the environment may grow.
struct TimeSlack {
  SourceSpan where;    // its TIME or DEVICE
  std::string amount;  // "1 ms", ">= 1 ms", "unlimited"
  std::string explanation;
};

/// Changes of texts with which everything holds that did not: each was made and proved.
struct Cure {
  std::string title;                      // "in SM1: wait for motion request before pc-force is read"
  std::vector<std::string> requirements;  // those that fail, or are undecided, without it
  std::vector<Edit> edits;
};

/// What can be said beyond the verdicts, of a skill in an environment.
struct Advice {
  std::string skill;
  std::vector<TimeSlack> slacks;  // where everything holds
  std::vector<Cure> cures;        // where something does not
};

enum class Depth {
  quick,  // whether each requirement holds
  whole   // and the bounds that runs attain
};

class Prover {
 public:
  virtual ~Prover() = default;

  /// Takes about `seconds` at most. Once `stop` says true it ends soon, and what it gives is not used. All
  /// places are those of `sources`, which `skill` and `environment` come from. `told` is called now and then,
  /// if it is given, with what is known by then: what is not decided is open, and there are no charts.
  virtual SkillProof prove(const pan::Network& skill, const pan::Environment& environment,
                           const SourceManager& sources, Depth depth, double seconds,
                           const std::function<bool()>& stop,
                           const std::function<void(SkillProof)>& told) const = 0;

  /// Likewise. Edits are of files of `sources`.
  virtual Advice advise(const pan::Network& skill, const pan::Environment& environment,
                        const SourceManager& sources, double seconds,
                        const std::function<bool()>& stop) const = 0;
};

}  // namespace pal::language_server
