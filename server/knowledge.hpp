// What is known of the cell's skills beyond what running them needs: their templates in full, what is proved
// of them, their pictures. It may come while the server serves, for proofs take their time.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "operations/ways.hpp"
#include "pal/pan/network.hpp"

namespace pal::server {

struct KnownRequirement {
  enum class Verdict { holds, fails, undecided, not_proved, proving };
  std::string name, text;
  Verdict verdict = Verdict::not_proved;
  std::optional<double> bound, limit;  // in `unit`
  std::string unit;                    // "s", or "%" of a load
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
  operations::SkillTimes times;
};

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

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Facts> facts_ = std::make_shared<Facts>();
};

}  // namespace pal::server
