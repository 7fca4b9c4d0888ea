// A skill written by hand in a test: tables and coroutines as generated code has them, without the generator.
#pragma once

#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"
#include "pal/runtime/thread.hpp"

namespace pal::test {

using namespace std::chrono_literals;

class WrittenSkill final : public runtime::Skill {
 public:
  using Body = std::function<runtime::Task(runtime::Thread&)>;

  std::vector<runtime::ProcessorSpec> processors;
  std::vector<runtime::ThreadSpec> threads;
  std::vector<Body> bodies;  // one each thread
  std::vector<runtime::StatementSpec> statements;
  std::vector<runtime::ChannelSpec> channels;
  std::vector<std::string_view> conditions;
  std::vector<std::string_view> devices;
  runtime::Interval test;
  runtime::Latency latency;
  std::vector<runtime::DeviceTimes> times;
  std::vector<runtime::RequirementSpec> requirements;
  std::vector<runtime::KeptSpec> kept;
  std::function<bool(const runtime::BrokenPromise&)> on_promise_broken;

  int processor(std::string_view name, bool preemptive = true) {
    processors.push_back({name, preemptive});
    return static_cast<int>(processors.size()) - 1;
  }
  int thread(std::string_view name, int where, int priority, Body body) {
    threads.push_back({name, where, priority, -1, true});
    bodies.push_back(std::move(body));
    return static_cast<int>(threads.size()) - 1;
  }
  int block(std::string_view name, int parent, int where, int priority, bool can_end, Body body) {
    threads.push_back({name, where, priority, parent, can_end});
    bodies.push_back(std::move(body));
    return static_cast<int>(threads.size()) - 1;
  }
  int statement(std::string_view text, runtime::Interval cost = {}) {
    statements.push_back({"M", text, "written.pal", static_cast<int>(statements.size()) + 1, cost});
    return static_cast<int>(statements.size()) - 1;
  }
  int statement(std::string_view text, runtime::Time cost) { return statement(text, {cost, cost}); }
  int channel(std::string_view sender, std::string_view message, std::string_view receiver) {
    channels.push_back({sender, message, receiver, {}, -1, message.substr(0, 7) == "request", false, false});
    return static_cast<int>(channels.size()) - 1;
  }
  int condition(std::string_view name) {
    conditions.push_back(name);
    return static_cast<int>(conditions.size()) - 1;
  }

  const runtime::SkillDescription& description() const override { return description_; }
  const runtime::Wiring& wiring() const override {
    const runtime::Wiring now{"written", "bench", processors, threads, statements,   channels, conditions,
                              devices,   test,    latency,    times,   requirements, kept};
    // What is the same is not written again: threads of a run in real time may be reading it.
    static_assert(std::is_trivially_copyable_v<runtime::Wiring>);
    if (std::memcmp(&wiring_, &now, sizeof now) != 0) wiring_ = now;
    return wiring_;
  }
  void reset_parameters() override {}
  void set_parameter(std::string_view name, double) override {
    runtime::unknown_parameter(description_, name);
  }
  void start() override {}
  runtime::Task body(std::size_t index, runtime::Thread& thread) override { return bodies[index](thread); }
  void reserve_executed(runtime::Thread&) override {}
  bool promise_broken(const runtime::BrokenPromise& broken) override {
    return on_promise_broken && on_promise_broken(broken);
  }

 private:
  std::vector<runtime::CompletionSpec> completions_{{0, runtime::CompletionSpec::Kind::normal, "done"},
                                                    {9, runtime::CompletionSpec::Kind::error, "error"}};
  runtime::SkillDescription description_{"written", "bench", {}, {}, completions_};
  mutable runtime::Wiring wiring_;
};

class NoWorld final : public runtime::World {
 public:
  void advance_to(runtime::Time when) override {
    if (when < last) throw std::logic_error("back in time");
    last = when;
  }
  runtime::Time last{};
};

/// One line an event: "3ms take B `WTM( x from A )` x".
std::string to_text(const trace::Trace& trace);

/// The lines of to_text that contain one of `words`.
std::string only(const std::string& text, const std::vector<std::string>& words);

}  // namespace pal::test
