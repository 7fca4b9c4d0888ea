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

/// In the requirement's unit.
struct MeasuredRequirement {
  double worst = 0;  // since the server began; of a load that of the last run
  double now = 0;    // the last value that was seen
};
/// By skill and name.
using MeasuredRequirements = std::map<std::pair<std::string, std::string>, MeasuredRequirement>;

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
  /// `value` is the longest that a run has seen, or the shortest of a limit from below; `now` is what it saw
  /// last. `last`: only the last one counts, as of a load, which is of the run so far.
  void measure(const std::string& skill, const std::string& requirement, MeasuredRequirement value,
               bool at_least, bool last = false) {
    const std::lock_guard lock(mutex_);
    const auto [found, fresh] = measured_.try_emplace({skill, requirement}, value);
    if (fresh) return;
    const double before = found->second.worst;
    found->second = {last       ? value.worst
                     : at_least ? std::min(before, value.worst)
                                : std::max(before, value.worst),
                     value.now};
  }

 private:
  mutable std::mutex mutex_;
  MeasuredRequirements measured_;
  std::shared_ptr<const Facts> facts_ = std::make_shared<Facts>();
};

}  // namespace pal::server
