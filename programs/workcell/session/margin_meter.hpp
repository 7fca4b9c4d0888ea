// How near the skills that run come to their requirements, told while they run, by a thread of its own.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "operations/executor.hpp"
#include "pal/runtime/margins.hpp"
#include "pal/runtime/skill.hpp"
#include "server/knowledge.hpp"

namespace pal::workcell {

/// The run itself measures, and never waits for this.
class MarginMeter {
 public:
  /// The knowledge outlives it.
  explicit MarginMeter(server::Knowledge& knowledge);
  ~MarginMeter();
  MarginMeter(const MarginMeter&) = delete;
  MarginMeter& operator=(const MarginMeter&) = delete;

  /// The skill, which outlives the run, is about to run. Where its run puts what it measures; null: it has no
  /// requirement.
  runtime::Margins* begin(const runtime::Skill& skill);
  /// Its run is over. The worst of each requirement in it, in the requirement's unit.
  std::vector<operations::Figure> end();

 private:
  void work();
  struct Measured {
    std::string name;
    server::MeasuredRequirement value;
    bool at_least = false, is_load = false;
  };
  std::vector<Measured> measured() const;
  void tell();

  server::Knowledge& knowledge_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::unique_ptr<runtime::Margins> margins_;
  const runtime::Wiring* wiring_ = nullptr;  // of the skill that runs; null: none does
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace pal::workcell
