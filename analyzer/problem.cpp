#include "analyzer/problem.hpp"

#include <map>
#include <memory>
#include <set>
#include <unordered_set>

#include "analyzer/compile.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::analyzer {
namespace {

using namespace pan;

/// Longer than any cell's figure (eleven days), and short enough that sums along a run stay far from
/// overflow.
constexpr Nanoseconds longest_time = 1'000'000'000'000'000;

constexpr int most_threads = 20'000;
constexpr int most_conditions = 64;
constexpr int most_channels = 40'000;
constexpr int most_explored_threads = 100;
constexpr int most_explored_channels = 120;

class Builder final : public TimesAndPlaces {
 public:
  Builder(const Network& network, const Environment& environment, Diagnostics& diagnostics,
          const SourceManager* sources)
      : network_(network), environment_(environment), diagnostics_(diagnostics), sources_(sources) {}

  std::optional<Problem> build() {
    const std::size_t before = diagnostics_.errors();
    problem_.skill = network_.skill.name;
    problem_.environment = environment_.name;
    for (const Completion& completion : network_.skill.completions) {
      if (completion.kind == Completion::Kind::error) problem_.error_code = completion.code;
    }
    for (const Condition& condition : network_.conditions) problem_.conditions.push_back(condition.name);
    for (const Module& module : network_.modules) problem_.module_names.push_back(module.name);
    processors();
    known_names();
    common_times();
    channels();
    devices();
    compile(network_, *this, sources_, diagnostics_, problem_);
    latencies();
    requirements();
    limits();
    if (diagnostics_.errors() != before) return std::nullopt;
    return std::move(problem_);
  }

  const Costs& costs() const override { return environment_.costs; }

  Range activity(const Activity& activity) override {
    const std::string& module = network_.modules[activity.module.index()].name;
    const ActivityTime* found = nullptr;
    for (const ActivityTime& time : environment_.activities) {
      if (time.activity != activity.name || !(time.module.empty() || time.module == module)) continue;
      if (found == nullptr || found->module.empty()) found = &time;
    }
    if (found != nullptr) return {found->time.best.count(), found->time.worst.count()};
    if (untimed_.insert(activity.name + " OF " + module).second) {
      diagnostics_
          .report(Code::PAL0725, environment_.where,
                  "environment " + environment_.name + " gives activity " + activity.name + " of " + module +
                      " no time",
                  "add TIME " + activity.name + " OF " + module + " : … to the environment")
          .notes.push_back({activity.where, "the activity"});
    }
    return {};
  }

  void place(Thread& thread, int parent) override {
    const Placement* placement = placement_of(thread.name);
    if (placement == nullptr && parent >= 0) {
      const Thread& above = problem_.threads[static_cast<std::size_t>(parent)];
      const std::string module = thread.name.substr(0, thread.name.find('.'));
      placement = placement_of(module);
      if (placement == nullptr) {
        thread.processor = above.processor;
        thread.priority = above.priority;
        return;
      }
    }
    if (placement == nullptr) {
      diagnostics_.report(Code::PAL0721, environment_.where,
                          "environment " + environment_.name + " places " + thread.name + " nowhere",
                          "add PLACE " + thread.name + " ON … to the environment");
      thread.processor = 0;
      return;
    }
    const auto processor = processor_.find(placement->processor);
    thread.processor = processor == processor_.end() ? 0 : processor->second;
    thread.priority = placement->priority;
  }

 private:
  const Placement* placement_of(const std::string& thread) const {
    for (const Placement& placement : environment_.placements) {
      if (placement.thread == thread) return &placement;
    }
    return nullptr;
  }

  void processors() {
    for (const Processor& processor : environment_.processors) {
      const bool added =
          processor_.emplace(processor.name, static_cast<int>(problem_.processors.size())).second;
      if (!added) {
        diagnostics_.report(Code::PAL0728, processor.where,
                            "processor " + processor.name + " is declared twice");
        continue;
      }
      problem_.processors.push_back(processor);
    }
    if (problem_.processors.empty()) {
      diagnostics_.report(Code::PAL0721, environment_.where,
                          "environment " + environment_.name + " has no processor", "add PROCESSOR P0");
    }
  }

  /// An environment serves several skills, so it may name modules, devices and activities that this one
  /// lacks; what this one needs and misses is found where it is needed. Nothing may be said twice.
  void known_names() {
    std::set<std::string> threads;
    std::set<std::string> modules;
    for (const Module& module : network_.modules) {
      if (module.body.empty()) continue;
      modules.insert(module.name);
      for (const std::string& name : module.threads) threads.insert(name);
      if (module.executed_by.valid()) executed_.insert(module.name);
    }
    std::set<std::string> placed;
    for (const Placement& placement : environment_.placements) {
      if (!processor_.contains(placement.processor)) {
        diagnostics_.report(Code::PAL0722, placement.where, "there is no processor " + placement.processor);
      }
      if (!placed.insert(placement.thread).second) {
        diagnostics_.report(Code::PAL0728, placement.where, placement.thread + " is placed twice");
      }
      if (executed_.contains(placement.thread)) {
        diagnostics_.report(
            Code::PAL0723, placement.where,
            placement.thread + " is no thread: it runs by Execute, in the thread of its caller",
            "leave the placement out");
      } else if (modules.contains(placement.thread.substr(0, placement.thread.find('.'))) &&
                 !threads.contains(placement.thread)) {
        diagnostics_.report(Code::PAL0723, placement.where,
                            "skill " + network_.skill.name + " has no block " + placement.thread);
      }
    }
    std::set<std::pair<std::string, std::string>> timed;
    for (const ActivityTime& time : environment_.activities) {
      if (!timed.insert({time.activity, time.module}).second) {
        diagnostics_.report(Code::PAL0728, time.where,
                            "activity " + time.activity + " is given a time twice");
      }
      interval(time.time, time.where, "activity " + time.activity);
    }
  }

  void time(Duration value, SourceSpan where, const std::string& what, bool positive = false) {
    if (value.count() < 0) {
      diagnostics_.report(Code::PAL0726, where, "the time of " + what + " is negative");
    } else if (positive && value.count() == 0) {
      diagnostics_.report(Code::PAL0726, where, "the time of " + what + " is zero",
                          "give it a time above zero");
    } else if (value.count() > longest_time) {
      diagnostics_.report(Code::PAL0726, where, "the time of " + what + " is too long to reckon with",
                          "the longest time is 1000000 s");
    }
  }

  void interval(const Interval& value, SourceSpan where, const std::string& what) {
    time(value.best, where, what);
    time(value.worst, where, what);
    if (value.best > value.worst) {
      diagnostics_.report(Code::PAL0726, where, "the best time of " + what + " is longer than its worst",
                          "write the shorter time first");
    }
  }

  void common_times() {
    const Costs& costs = environment_.costs;
    interval(costs.send, environment_.where, "a send");
    interval(costs.receive, environment_.where, "a receive");
    interval(costs.set, environment_.where, "a set");
    interval(costs.read, environment_.where, "a read");
    interval(costs.test, environment_.where, "a test");
    interval(environment_.latency.within_processor, environment_.where, "a message within a processor");
    interval(environment_.latency.between_processors, environment_.where, "a message between processors");
    for (const Module& module : network_.modules) {
      for (const Node& node : module.body.nodes) {
        const auto* wait = std::get_if<Wait>(&node.content);
        if (wait != nullptr && wait->within) time(*wait->within, node.where, "this wait");
      }
    }
  }

  void channels() {
    for (const pan::Channel& channel : network_.channels) {
      Channel made;
      made.sender_device = device_of(network_, channel.sender);
      made.receiver_device = device_of(network_, channel.receiver);
      if (made.sender_device < 0)
        made.sender_module = static_cast<int>(std::get<ModuleId>(channel.sender).index());
      if (made.receiver_device < 0) {
        made.receiver_module = static_cast<int>(std::get<ModuleId>(channel.receiver).index());
      }
      if (channel.answer.valid()) made.answer = static_cast<int>(channel.answer.index());
      made.message = network_.messages[channel.message.index()].name;
      problem_.channels.push_back(std::move(made));
    }
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
      const int answer = problem_.channels[c].answer;
      if (answer >= 0) problem_.channels[static_cast<std::size_t>(answer)].answers = static_cast<int>(c);
    }
  }

  struct World {
    std::string name;
    SourceSpan where;
    bool module;
  };

  void devices() {
    std::vector<World> world;
    for (const pan::Device& device : network_.devices) world.push_back({device.name, device.where, false});
    for (const Module& module : network_.modules) {
      if (module.body.empty()) world.push_back({module.name, module.where, true});
    }
    std::set<std::string> described;
    for (const DeviceTiming& timing : environment_.devices) {
      if (!described.insert(timing.device).second) {
        diagnostics_.report(Code::PAL0728, timing.where, "device " + timing.device + " is described twice");
      }
    }
    for (std::size_t d = 0; d < world.size(); ++d) device(world[d], static_cast<int>(d));
  }

  void device(const World& thing, int index) {
    Device made;
    made.name = thing.name;
    std::set<int> sent;
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
      if (problem_.channels[c].sender_device == index) sent.insert(static_cast<int>(c));
    }
    const DeviceTiming* timing = nullptr;
    for (const DeviceTiming& each : environment_.devices) {
      if (each.device == thing.name) timing = &each;
    }
    if (timing == nullptr) {
      if (!sent.empty()) {
        const std::string what = thing.module ? "module " + thing.name + " has no body, and environment "
                                              : "device " + thing.name + " sends messages, and environment ";
        diagnostics_.report(Code::PAL0724, thing.where,
                            what + environment_.name + " does not say how it behaves",
                            "add DEVICE " + thing.name + " … to the environment" +
                                (thing.module ? ", or give the module a body" : ""));
      }
      problem_.devices.push_back(std::move(made));
      return;
    }
    if (const auto* event = std::get_if<EventDevice>(&timing->behaviour)) {
      event_device(*event, *timing, index, sent, made);
    } else {
      served_device(*timing, index, sent, made);
    }
    for (int c : sent) {
      diagnostics_.report(Code::PAL0727, timing->where,
                          thing.name + " never sends " +
                              problem_.channels[static_cast<std::size_t>(c)].message +
                              ", which the skill waits for");
    }
    problem_.devices.push_back(std::move(made));
  }

  void event_device(const EventDevice& event, const DeviceTiming& timing, int index, std::set<int>& sent,
                    Device& made) {
    made.behaviour = event;
    time(event.period, timing.where, "the period of " + made.name, true);
    time(event.jitter, timing.where, "the jitter of " + made.name);
    if (event.jitter >= event.period && event.period.count() > 0) {
      diagnostics_.report(Code::PAL0726, timing.where,
                          "the jitter of " + made.name + " is not shorter than its period");
    }
    if (event.phase) {
      time(*event.phase, timing.where, "the phase of " + made.name);
      if (*event.phase > event.period) {
        diagnostics_.report(Code::PAL0726, timing.where,
                            "the phase of " + made.name + " is longer than its period");
      }
    }
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
      const Channel& channel = problem_.channels[c];
      if (channel.sender_device == index && channel.message == event.message) {
        made.event = static_cast<int>(c);
        sent.erase(made.event);
      }
    }
    if (made.event < 0) {
      diagnostics_.report(
          Code::PAL0727, timing.where,
          "nothing in skill " + network_.skill.name + " waits for " + event.message + " from " + made.name);
    }
  }

  void served_device(const DeviceTiming& timing, int index, std::set<int>& sent, Device& made) {
    if (const auto* request = std::get_if<RequestDevice>(&timing.behaviour)) {
      made.behaviour = *request;
      interval(request->answer, timing.where, "an answer of " + made.name);
    } else {
      const auto& frames = std::get<FrameDevice>(timing.behaviour);
      made.behaviour = frames;
      time(frames.period, timing.where, "the period of " + made.name, true);
      time(frames.collecting, timing.where, "collecting a frame of " + made.name);
      if (frames.collecting > frames.period) {
        diagnostics_.report(Code::PAL0726, timing.where,
                            made.name + " collects a frame for longer than its period");
      }
      if (frames.phase) {
        time(*frames.phase, timing.where, "the phase of " + made.name);
        if (*frames.phase > frames.period) {
          diagnostics_.report(Code::PAL0726, timing.where,
                              "the phase of " + made.name + " is longer than its period");
        }
      }
    }
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
      Channel& channel = problem_.channels[c];
      if (channel.receiver_device != index || channel.answer < 0) continue;
      channel.served = true;
      made.requests.push_back(static_cast<int>(c));
      sent.erase(channel.answer);
    }
  }

  void latencies() {
    const Interval& within = environment_.latency.within_processor;
    const Interval& between = environment_.latency.between_processors;
    problem_.within_processor = {within.best.count(), within.worst.count()};
    problem_.between_processors = {between.best.count(), between.worst.count()};
    const std::vector<std::set<int>> takers_of = takers();
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
      const std::set<int>& processors = takers_of[c];
      problem_.channels[c].receiver_processors.assign(processors.begin(), processors.end());
    }
  }

  /// Steps that a thread can reach, its blocks' steps left out.
  std::vector<std::size_t> steps_of(const Thread& thread) const {
    std::unordered_set<std::size_t> seen;
    std::vector<std::size_t> found;
    std::vector<int> open{thread.entry};
    while (!open.empty()) {
      const auto at = static_cast<std::size_t>(open.back());
      open.pop_back();
      if (!seen.insert(at).second) continue;
      found.push_back(at);
      open.insert(open.end(), problem_.steps[at].next.begin(), problem_.steps[at].next.end());
    }
    return found;
  }

  /// By channel: the processors of the threads that wait for it.
  std::vector<std::set<int>> takers() const {
    std::vector<std::set<int>> found(problem_.channels.size());
    for (const Thread& thread : problem_.threads) {
      for (std::size_t s : steps_of(thread)) {
        const Step& step = problem_.steps[s];
        if (step.kind != Step::Kind::wait) continue;
        for (int c : step.channels) found[static_cast<std::size_t>(c)].insert(thread.processor);
      }
    }
    return found;
  }

  std::vector<bool> steps_at(const std::vector<StatementRef>& at, const pan::Requirement& requirement) {
    std::vector<bool> steps(problem_.steps.size());
    bool any = false;
    for (const StatementRef& ref : at) {
      for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
        const int statement = problem_.steps[s].statement;
        if (statement < 0) continue;
        const Statement& known = problem_.statements[static_cast<std::size_t>(statement)];
        if (known.source_module == ref.module.value && known.source_node == ref.node.value)
          steps[s] = any = true;
      }
    }
    if (!any) {
      diagnostics_.report(
          Code::PAL0811, requirement.where,
          "requirement " + requirement.name + " is about a statement that no thread ever reaches");
    }
    return steps;
  }

  void requirements() {
    for (const pan::Requirement& requirement : network_.requirements) {
      Requirement made;
      made.name = requirement.name;
      made.limit = requirement.limit.count();
      made.where = requirement.where;
      if (made.limit < 0 || made.limit > longest_time) {
        diagnostics_.report(Code::PAL0814, requirement.where,
                            "the limit of " + requirement.name + " is impossible");
      }
      if (const auto* age = std::get_if<Age>(&requirement.measure)) {
        made.measure = Requirement::Measure::age;
        made.condition = static_cast<int>(age->condition.index());
        made.at = steps_at(age->at, requirement);
      } else if (const auto* response = std::get_if<Response>(&requirement.measure)) {
        made.measure = Requirement::Measure::response;
        made.event = static_cast<int>(response->event.index());
        made.at = steps_at(response->at, requirement);
        made.device = problem_.channels[response->event.index()].sender_device;
        const bool event =
            made.device >= 0 && problem_.devices[static_cast<std::size_t>(made.device)].event == made.event;
        if (!event) {
          diagnostics_.report(Code::PAL0812, requirement.where,
                              problem_.channels[response->event.index()].message +
                                  " is no event of a device in environment " + environment_.name,
                              "describe its sender as DEVICE … EVENT in the environment");
        }
      } else {
        load(std::get<Load>(requirement.measure), requirement, made);
      }
      problem_.requirements.push_back(std::move(made));
    }
    for (std::size_t d = 0; d < problem_.devices.size(); ++d) demanded_answer(static_cast<int>(d));
  }

  void load(const Load& load, const pan::Requirement& requirement, Requirement& made) {
    made.measure = Requirement::Measure::load;
    for (std::size_t p = 0; p < problem_.processors.size(); ++p) {
      if (load.processor.empty() || load.processor == problem_.processors[p].name) {
        made.processors.push_back(static_cast<int>(p));
      }
    }
    if (made.processors.empty()) {
      diagnostics_.report(Code::PAL0813, requirement.where,
                          "environment " + environment_.name + " has no processor " + load.processor);
    }
  }

  /// What an event device demands of whoever takes its events is a requirement like the skill's own.
  void demanded_answer(int d) {
    const Device& device = problem_.devices[static_cast<std::size_t>(d)];
    const auto* event = std::get_if<EventDevice>(&device.behaviour);
    if (event == nullptr || event->answer.empty() || device.event < 0) return;
    SourceSpan where;
    for (const DeviceTiming& timing : environment_.devices) {
      if (timing.device == device.name) where = timing.where;
    }
    Requirement made;
    made.name = device.name + ".answer";
    made.measure = Requirement::Measure::response;
    made.event = device.event;
    made.device = d;
    made.where = where;
    made.at.assign(problem_.steps.size(), false);
    bool any = false;
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      const Step& step = problem_.steps[s];
      if (step.kind != Step::Kind::send) continue;
      const Channel& channel = problem_.channels[static_cast<std::size_t>(step.channels.front())];
      if (channel.receiver_device == d && channel.message == event->answer) made.at[s] = any = true;
    }
    if (!any) {
      diagnostics_.report(
          Code::PAL0727, where,
          "nothing in skill " + network_.skill.name + " sends " + event->answer + " to " + device.name);
      return;
    }
    if (!event->answer_within) return;
    time(*event->answer_within, where, "an answer to " + device.name);
    made.limit = event->answer_within->count();
    problem_.requirements.push_back(std::move(made));
  }

  void limits() {
    const bool fits = static_cast<int>(problem_.threads.size()) <= most_threads &&
                      static_cast<int>(problem_.conditions.size()) <= most_conditions &&
                      static_cast<int>(problem_.channels.size()) <= most_channels &&
                      problem_.steps.size() < 30000;
    if (!fits) {
      diagnostics_.report(Code::PAL0730, network_.skill.where,
                          "skill " + network_.skill.name + " is too large to analyse",
                          "it may have 20000 threads, 40000 channels, 64 conditions and 30000 statements");
    }
  }

  const Network& network_;
  const Environment& environment_;
  Diagnostics& diagnostics_;
  const SourceManager* sources_;
  Problem problem_;
  std::map<std::string, int> processor_;
  std::set<std::string> executed_;
  std::set<std::string> untimed_;
};

}  // namespace

bool fits_exploration(const Problem& problem) {
  return static_cast<int>(problem.threads.size()) <= most_explored_threads &&
         static_cast<int>(problem.channels.size()) <= most_explored_channels;
}

std::optional<Problem> make_problem(const Network& network, const Environment& environment,
                                    Diagnostics& diagnostics, const SourceManager* sources) {
  return Builder(network, environment, diagnostics, sources).build();
}

}  // namespace pal::analyzer
