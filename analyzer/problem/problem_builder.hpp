// Building a problem: what the files problem*.cpp share.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analyzer/problem/compile.hpp"

namespace pal::analyzer {

/// Longer than any cell's figure (eleven days), and short enough that sums along a run stay far from
/// overflow.
constexpr Nanoseconds longest_time = 1'000'000'000'000'000;

class ProblemBuilder final : public TimesAndPlaces {
 public:
  ProblemBuilder(const pan::Network& network, const pan::Environment& environment, Diagnostics& diagnostics,
                 const SourceManager* sources)
      : network_(network), environment_(environment), diagnostics_(diagnostics), sources_(sources) {
    for (const pan::ActivityTime& time : environment_.activities) {
      if (time.module.empty()) times_[{time.activity, time.module}] = &time;
      times_.emplace(std::pair(time.activity, time.module), &time);
    }
    for (const pan::Placement& placement : environment_.placements)
      placements_.emplace(placement.thread, &placement);
    for (const pan::DeviceTiming& timing : environment_.devices) timings_[timing.device] = &timing;
  }

  std::optional<Problem> build();

  const pan::Costs& costs() const override { return environment_.costs; }
  Range activity(const pan::Activity& activity) override;
  void place(Thread& thread, ThreadId runner) override;

 private:
  // Names, places and times (problem.cpp).
  /// Of a thread, or of the thread in whose place it runs; null: neither has one.
  const pan::Placement* placement_of(std::string thread) const;
  void processors();
  void known_names();
  void loops();
  void common_times();
  void channels();
  void latencies();
  /// The processors of the threads that wait for each channel.
  Table<ChannelId, std::set<ProcessorId>> takers() const;
  void limits();
  void time(Duration value, SourceSpan where, const std::string& what, bool positive = false);
  void interval(const Interval& value, SourceSpan where, const std::string& what);

  // More work than time (problem_overload.cpp).
  void overload();

  // The world (problem_devices.cpp).
  struct World {
    std::string name;
    SourceSpan where;
    bool module;
  };
  void devices();
  void device(const World& thing, DeviceId index);
  void event_device(const pan::EventDevice& event, const pan::DeviceTiming& timing, DeviceId index,
                    std::set<ChannelId>& sent, Device& made);
  void phase(const std::optional<Duration>& value, Duration period, const pan::DeviceTiming& timing,
             const std::string& device);
  void endless_waits();
  void served_device(const pan::DeviceTiming& timing, DeviceId index, std::set<ChannelId>& sent,
                     Device& made);

  // What is required (problem_requirements.cpp).
  Table<StepId, bool> steps_at(const std::vector<pan::StatementRef>& at, const pan::Requirement& requirement);
  Table<StepId, bool> steps_in(const std::vector<pan::StatementRef>& loops) const;
  void requirements();
  void require(Requirement made);
  void demanded_answer(DeviceId device);
  void known(const pan::Known& known, Requirement& made);
  std::vector<ProcessorId> processors_named(const std::string& name, const pan::Requirement& requirement);
  void measure(const pan::Response& response, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::Age& age, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::Reaction& reaction, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::Passes& passes, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::Loss& loss, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::Completing& completing, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::Load& load, const pan::Requirement& requirement, Requirement made);
  void measure(const pan::BusyPeriod& busy, const pan::Requirement& requirement, Requirement made);

  const pan::Network& network_;
  const pan::Environment& environment_;
  Diagnostics& diagnostics_;
  const SourceManager* sources_;
  Problem problem_;
  std::map<std::string, ProcessorId> processor_;
  std::set<std::string> executed_;
  std::map<std::pair<std::string, std::string>, const pan::ActivityTime*> times_;  // by activity and module
  std::map<std::pair<pan::ModuleId, pan::NodeId>, std::vector<StepId>>
      steps_of_;                                             // by statement, if asked for
  std::map<std::string, const pan::Placement*> placements_;  // by thread; of two the first
  std::map<std::string, const pan::DeviceTiming*> timings_;  // by device; of two the last
  Table<DeviceId, std::vector<ChannelId>> sent_;
  std::set<std::string> untimed_;
};

}  // namespace pal::analyzer
