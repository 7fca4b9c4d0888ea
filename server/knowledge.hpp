// What is known of the cell's skills beyond what running them needs: their templates in full, what is proved
// of them, their pictures. It may come while the server serves, for proofs take their time.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "operations/ways.hpp"
#include "pal/pan/network.hpp"

namespace pal::server {

struct KnownRequirement {
  enum class Verdict { holds, fails, undecided, not_proved, proving };
  std::string name, text;
  Verdict verdict = Verdict::not_proved;
  std::optional<double> bound, limit;  // in `unit`
  std::string unit;                    // "s", "%" of a load, "" of a loss: a number
  bool at_least = false;               // the limit is one from below
};

struct SkillFacts {
  struct Picture {
    std::string title, path;  // at this server
  };
  pan::Template skill;  // as its PAL has it
  std::vector<KnownRequirement> requirements;
  std::string tool;         // that it needs; empty: any
  std::string environment;  // in which it is proved
  std::vector<Picture> pictures;
};

struct Facts {
  std::map<std::string, SkillFacts> skills;
  operations::ProvedTimes times;
};

/// The worst of each requirement, by skill and name, in the requirement's unit.
using MeasuredRequirements = std::map<std::pair<std::string, std::string>, double>;

/// For all threads.
class Knowledge {
 public:
  std::shared_ptr<const Facts> now() const {
    const std::lock_guard lock(mutex_);
    return facts_;
  }
  void learn(std::shared_ptr<const Facts> facts) {
    const std::lock_guard lock(mutex_);
    facts_ = std::move(facts);
  }
  /// Since the server began, of what a run can show.
  MeasuredRequirements measured() const {
    const std::lock_guard lock(mutex_);
    return measured_;
  }
  /// The longest that was seen, or the shortest of a limit from below. `last`: only the last one counts, as
  /// of a load, which is of the run so far.
  void measure(const std::string& skill, const std::string& requirement, double value, bool at_least,
               bool last = false) {
    const std::lock_guard lock(mutex_);
    const auto [found, fresh] = measured_.try_emplace({skill, requirement}, value);
    if (!fresh)
      found->second = last       ? value
                      : at_least ? std::min(found->second, value)
                                 : std::max(found->second, value);
  }

 private:
  mutable std::mutex mutex_;
  MeasuredRequirements measured_;
  std::shared_ptr<const Facts> facts_ = std::make_shared<Facts>();
};

}  // namespace pal::server
