// Distributed systems of event chains: described, drawn at random, and as PAL and as the analyzer's model.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::test {

/// Chains of modules, each started by a device's events, linked by messages of one slot.
struct ChainSystem {
  struct Stage {
    analyzer::ProcessorId processor{0};
    int priority = 0;
    analyzer::Nanoseconds best = 0;
    analyzer::Nanoseconds worst = 0;
  };
  struct Chain {
    analyzer::Nanoseconds period = 0;
    analyzer::Nanoseconds jitter = 0;
    bool sporadic = false;
    std::vector<Stage> stages;
  };
  std::vector<bool> preemptive;  // by processor
  std::vector<Chain> chains;
  analyzer::Range latency;  // between processors
};

struct ChainShape {
  int processors = 2;
  int chains = 2;
  int stages_least = 1;
  int stages_most = 6;
  double load = 0.5;  // of each processor that has a stage
  bool may_be_nonpreemptive = false;
};

/// The same seed gives the same system. Priorities on a processor differ; those of chains with short periods
/// are greater. Times are whole microseconds, odd on purpose, so that few instants fall together.
inline ChainSystem random_chains(std::uint64_t seed, const ChainShape& shape) {
  std::mt19937_64 engine(seed);
  const auto below = [&engine](std::uint64_t n) { return engine() % n; };
  const auto real = [&engine] { return static_cast<double>(engine() >> 11U) * 0x1.0p-53; };
  ChainSystem made;
  for (int p = 0; p < shape.processors; ++p)
    made.preemptive.push_back(!shape.may_be_nonpreemptive || below(4) != 0);
  made.latency = {static_cast<analyzer::Nanoseconds>(below(200) * 1000), 0};
  made.latency.worst = made.latency.best + static_cast<analyzer::Nanoseconds>(below(300) * 1000);
  struct Place {
    std::size_t chain;
    std::size_t stage;
    double weight;
  };
  Table<analyzer::ProcessorId, std::vector<Place>> on(static_cast<std::size_t>(shape.processors));
  for (int c = 0; c < shape.chains; ++c) {
    ChainSystem::Chain chain;
    // 10 to 100 ms, as many short as long ones.
    chain.period = static_cast<analyzer::Nanoseconds>(10'000 * std::pow(10.0, real())) * 1000 +
                   1000 * static_cast<analyzer::Nanoseconds>(below(7));
    const auto stages = static_cast<std::size_t>(shape.stages_least) +
                        below(static_cast<std::uint64_t>(shape.stages_most - shape.stages_least + 1));
    for (std::size_t s = 0; s < stages; ++s) {
      ChainSystem::Stage stage;
      stage.processor = analyzer::ProcessorId(below(static_cast<std::uint64_t>(shape.processors)));
      on[stage.processor].push_back({made.chains.size(), s, 0.1 + real()});
      chain.stages.push_back(stage);
    }
    made.chains.push_back(std::move(chain));
  }
  for (std::vector<Place>& places : on) {
    double sum = 0;
    for (const Place& place : places) sum += place.weight;
    for (const Place& place : places) {
      ChainSystem::Chain& chain = made.chains[place.chain];
      ChainSystem::Stage& stage = chain.stages[place.stage];
      const double share = shape.load * place.weight / sum;
      stage.worst = std::max<analyzer::Nanoseconds>(
          1000, static_cast<analyzer::Nanoseconds>(share * static_cast<double>(chain.period) / 1000) * 1000);
      stage.best = stage.worst / 1000 * static_cast<analyzer::Nanoseconds>(300 + below(701));
    }
    std::vector<Place> order = places;
    std::stable_sort(order.begin(), order.end(), [&](const Place& a, const Place& b) {
      return made.chains[a.chain].period > made.chains[b.chain].period;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      made.chains[order[i].chain].stages[order[i].stage].priority = static_cast<int>(i) + 1;
    }
  }
  return made;
}

/// Small systems of whole milliseconds, so that much falls together: shared priorities, both kinds of
/// processors, jitter.
inline ChainSystem small_chains(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto below = [&engine](int n) { return static_cast<int>(engine() % static_cast<std::uint64_t>(n)); };
  constexpr analyzer::Nanoseconds millisecond = 1'000'000;
  ChainSystem made;
  const int processors = 1 + below(2);
  for (int p = 0; p < processors; ++p) made.preemptive.push_back(below(3) != 0);
  made.latency = {0, below(2) * millisecond};
  for (int chains = 1 + below(3); chains > 0; --chains) {
    ChainSystem::Chain chain;
    chain.period = (4 + below(12)) * millisecond;
    const auto late = 1 + static_cast<analyzer::Nanoseconds>(seed % 3);
    chain.jitter = below(3) == 0 ? late * millisecond : 0;
    for (int stages = 1 + below(3); stages > 0; --stages) {
      const analyzer::Nanoseconds best = below(3) * millisecond;
      chain.stages.push_back(
          {analyzer::ProcessorId::of(below(processors)), 1 + below(3), best, best + below(2) * millisecond});
    }
    made.chains.push_back(std::move(chain));
  }
  return made;
}

/// The same where events may take their time, and what they bring about may come more than a period later.
inline ChainSystem drifting_chains(std::uint64_t seed) {
  std::mt19937_64 engine(seed * 31 + 7);
  const auto below = [&engine](int n) { return static_cast<int>(engine() % static_cast<std::uint64_t>(n)); };
  constexpr analyzer::Nanoseconds millisecond = 1'000'000;
  ChainSystem made = small_chains(seed);
  const analyzer::Nanoseconds soonest = below(12) * millisecond;
  made.latency = {soonest, soonest + below(2) * millisecond};
  for (ChainSystem::Chain& chain : made.chains) chain.sporadic = below(3) != 0;
  return made;
}

/// So many chains of one stage, two a processor, all with the same times.
inline ChainSystem pairs_of_drivers(int chains) {
  constexpr analyzer::Nanoseconds millisecond = 1'000'000;
  ChainSystem made;
  made.preemptive.assign(static_cast<std::size_t>((chains + 1) / 2), true);
  for (int c = 0; c < chains; ++c) {
    ChainSystem::Chain chain;
    chain.period = 10 * millisecond;
    chain.stages.push_back({analyzer::ProcessorId::of(c / 2), 1 + c % 2, 2 * millisecond, 3 * millisecond});
    made.chains.push_back(std::move(chain));
  }
  return made;
}

/// 2 to 5 processors, 2 to 8 chains of 1 to 6 stages, load 30 to 90 %.
inline ChainShape benchmark_shape(std::uint64_t seed) {
  std::mt19937_64 engine(seed * 977 + 5);
  ChainShape shape;
  shape.processors = 2 + static_cast<int>(engine() % 4);
  shape.chains = 2 + static_cast<int>(engine() % 7);
  shape.load = 0.3 + 0.01 * static_cast<double>(engine() % 61);
  return shape;
}

/// The analyzer's model of a system, with a response requirement a chain, from its event to the work of its
/// last stage. Without a skill method, which would only wait.
inline analyzer::Problem problem_of(const ChainSystem& system) {
  using namespace analyzer;
  Problem made;
  made.skill = "chains";
  made.environment = "cell";
  for (std::size_t p = 0; p < system.preemptive.size(); ++p) {
    made.processors.push_back({"P" + std::to_string(p), static_cast<bool>(system.preemptive[p]), {}});
  }
  made.between_processors = system.latency;
  const auto statement = [&made](const std::string& module, const std::string& text) {
    Statement of;
    of.module = module;
    of.text = text;
    return made.statements.push_back(std::move(of));
  };
  for (std::size_t c = 0; c < system.chains.size(); ++c) {
    const ChainSystem::Chain& chain = system.chains[c];
    const std::string number = std::to_string(c + 1);
    Device device;
    device.name = "clock-" + number;
    pan::EventDevice event;
    event.period = Duration(chain.period);
    event.jitter = Duration(chain.jitter);
    event.sporadic = chain.sporadic;
    device.behaviour = event;
    device.event = analyzer::ChannelId(made.channels.size());
    const analyzer::DeviceId device_index(made.devices.size());
    made.devices.push_back(std::move(device));
    Requirement requirement;
    requirement.name = "chain-" + number;
    requirement.measure = Requirement::Measure::response;
    requirement.events = {made.devices.back().event};
    requirement.device = device_index;
    requirement.limit = 1'000'000'000'000;
    StepId last_work{};
    for (std::size_t s = 0; s < chain.stages.size(); ++s) {
      const ChainSystem::Stage& stage = chain.stages[s];
      const std::string name = "M" + number + "-" + std::to_string(s + 1);
      const pan::ModuleId module = made.module_names.push_back(name);
      Channel in;
      in.message = "x" + number + "-" + std::to_string(s);
      in.receiver_module = module;
      if (s == 0) {
        in.sender_device = device_index;
      } else {
        in.sender_module = made.threads.back().module;
      }
      in.receiver_processors = {stage.processor};
      const analyzer::ChannelId channel = made.channels.push_back(std::move(in));
      const analyzer::StepId first(made.steps.size());
      const analyzer::StepId second(first.index() + 1);
      Step wait;
      wait.kind = Step::Kind::wait;
      wait.statement = statement(name, "WTM( x )");
      wait.channels = {channel};
      wait.next = {second};
      Step work;
      work.kind = Step::Kind::activity;
      work.statement = statement(name, "work");
      work.cost = {stage.best, stage.worst};
      const bool last = s + 1 == chain.stages.size();
      work.next = {last ? first : analyzer::StepId(first.index() + 2)};
      last_work = second;
      made.steps.push_back(wait);
      made.steps.push_back(work);
      if (!last) {
        Step send;
        send.kind = Step::Kind::send;
        send.statement = statement(name, "TXM( x )");
        send.channels = {analyzer::ChannelId(channel.index() + 1)};
        send.next = {first};
        made.steps.push_back(send);
      }
      Thread thread;
      thread.name = name;
      thread.module = module;
      thread.processor = stage.processor;
      thread.priority = stage.priority;
      thread.can_end = false;
      thread.entry = first;
      made.threads.push_back(std::move(thread));
    }
    requirement.at.assign(last_work.index() + 1, false);
    requirement.at[last_work] = true;
    made.requirements.push_back(std::move(requirement));
  }
  for (Requirement& requirement : made.requirements) requirement.at.resize(made.steps.size(), false);
  return made;
}

/// Requires everything else of the chains, too. Of the last stage: the greatest and least interval, the age
/// of the event's sample, and the reaction. Of the event: no loss. Of the first stage: the response to its
/// message. Of the processors: the busy period.
inline void require_more(analyzer::Problem& problem) {
  using Measure = analyzer::Requirement::Measure;
  const std::vector<analyzer::Requirement> responses = problem.requirements;
  for (const analyzer::Requirement& response : responses) {
    const auto add = [&](Measure measure, const std::string& name) -> analyzer::Requirement& {
      analyzer::Requirement made = response;
      made.measure = measure;
      made.name = response.name + "." + name;
      made.events.clear();
      problem.requirements.push_back(made);
      return problem.requirements.back();
    };
    add(Measure::interval, "most");
    analyzer::Requirement& least = add(Measure::interval, "least");
    least.at_least = true;
    least.limit = 1;
    add(Measure::age, "age").samples = response.events;
    add(Measure::reaction, "reaction").samples = response.events;
    add(Measure::loss, "loss").limit = 0;
    // What the first stage sends on, and all that follows.
    const analyzer::ChannelId second(response.events.front().index() + 1);
    if (!problem.channels.contains(second) || !problem.channels[second].sender_module.valid()) continue;
    analyzer::Requirement& rest = add(Measure::response, "rest");
    rest.events = {second};
    rest.device = {};
  }
  analyzer::Requirement busy;
  busy.name = "busy";
  busy.measure = Measure::busy;
  busy.limit = 1'000'000'000'000;
  for (const analyzer::ProcessorId p : problem.processors.ids()) busy.processors.push_back(p);
  problem.requirements.push_back(busy);
}

/// The same as PAL. Stages are sensor drivers and logical sensors by turns, since these may talk.
inline std::string text_of(const ChainSystem& system) {
  const auto ns = [](analyzer::Nanoseconds time) { return std::to_string(time) + " ns"; };
  std::string messages = "MESSAGE stop : SIGNAL\nDEVICE button\n";
  std::string modules;
  std::string drivers = "stop-driver";
  std::string sensors = "stop-sensor";
  std::string requirements;
  std::string environment = "ENVIRONMENT cell\n  PROCESSOR idle\n";
  for (std::size_t p = 0; p < system.preemptive.size(); ++p) {
    environment += "  PROCESSOR P" + std::to_string(p) + (system.preemptive[p] ? "\n" : " NONPREEMPTIVE\n");
  }
  environment +=
      "  LATENCY BETWEEN PROCESSORS " + ns(system.latency.best) + " TO " + ns(system.latency.worst) + "\n";
  for (std::size_t c = 0; c < system.chains.size(); ++c) {
    const ChainSystem::Chain& chain = system.chains[c];
    const std::string number = std::to_string(c + 1);
    const std::string clock = "clock-" + number;
    messages += "DEVICE " + clock + "\n";
    environment += "  DEVICE " + clock + " EVENT x" + number +
                   (chain.sporadic ? "-0 SPORADIC " : "-0 EVERY ") + ns(chain.period) + " JITTER " +
                   ns(chain.jitter) + "\n";
    for (std::size_t s = 0; s < chain.stages.size(); ++s) {
      const ChainSystem::Stage& stage = chain.stages[s];
      const std::string place = std::to_string(s + 1);
      const auto name = [&](std::size_t of) {
        return (of % 2 == 0 ? "SD" : "LS") + number + "-" + std::to_string(of + 1);
      };
      std::string& list = s % 2 == 0 ? drivers : sensors;
      list += (list.empty() ? "" : ", ") + name(s);
      messages += "MESSAGE x" + number + "-" + std::to_string(s) + " : SIGNAL\n";
      modules += (s % 2 == 0 ? "Sensor Driver: " : "Logical Sensor: ") + name(s) +
                 "\n  ACTIVITY work\nBEGIN\n  REPEAT\n    WTM( x" + number + "-" + std::to_string(s) +
                 " from " + (s == 0 ? clock : name(s - 1)) + " )\n    work\n";
      if (s + 1 < chain.stages.size())
        modules += "    TXM( x" + number + "-" + place + " to " + name(s + 1) + " )\n";
      modules += "  UNTIL( forever )\nEND\n";
      environment += "  PLACE " + name(s) + " ON P" + std::to_string(stage.processor.index()) + " PRIORITY " +
                     std::to_string(stage.priority) + "\n  TIME work OF " + name(s) + " : " +
                     std::to_string(stage.best) + " TO " + ns(stage.worst) + "\n";
      if (s + 1 == chain.stages.size()) {
        requirements += "  REQUIREMENT chain-" + number + " : RESPONSE FROM x" + number + "-0 OF " + clock +
                        " TO work IN " + name(s) + " AT MOST 1000 s\n";
      }
    }
  }
  const std::string skill = "SKILL chains\n  SENSOR DRIVER " + drivers + "\n  LOGICAL SENSOR " + sensors + R"(
  MACHINE CONTROLLER NONE
  MODEL DATA NONE
  SKILL METHOD SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR "any other error"
)" + requirements + "END SKILL\n";
  const std::string stop = R"(Sensor Driver: stop-driver
BEGIN
  WTM( stop from button )
  TXM( stop to stop-sensor )
END
Logical Sensor: stop-sensor
BEGIN
  WTM( stop from stop-driver )
  TXM( stop to SM1 )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from stop-sensor )
  TXM( Completion Protocol 0 )
END
)";
  return messages + skill + modules + stop + environment + R"(  DEVICE button EVENT stop SPORADIC 1 ms
  PLACE stop-driver ON idle PRIORITY 3
  PLACE stop-sensor ON idle PRIORITY 2
  PLACE SM1 ON idle PRIORITY 1
END ENVIRONMENT
)";
}

}  // namespace pal::test
