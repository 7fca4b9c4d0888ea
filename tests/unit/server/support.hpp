// A cell of clockwork: a skill lasts until it is stopped, or no time at all.
#pragma once

#include <atomic>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/desk.hpp"

namespace pal::test {

/// "quick" ends at once with the code that its parameter says, "long" when it is stopped or let go.
class Clockwork final : public operations::SkillRunner {
 public:
  operations::SkillResult run(const std::string& skill, const std::vector<operations::Parameter>& parameters,
                              std::optional<Duration>) override {
    ++runs;
    std::this_thread::sleep_for(lasts);
    time += std::chrono::milliseconds(1);
    std::unique_lock lock(mutex_);
    if (skill == "long") {
      inside_ = true;
      changed_.notify_all();
      changed_.wait(lock, [this] { return stopped_.load() || !held_; });
      inside_ = false;
    }
    using Kind = operations::SkillResult::Kind;
    if (stopped_) return {Kind::stopped, 2, "stopped as asked"};
    int code = 0;
    if (!parameters.empty()) code = static_cast<int>(std::get<double>(parameters.front().value));
    return {code == 0 ? Kind::normal : Kind::contingency, code, "as told"};
  }
  bool delay(Duration length) override {
    time += length;
    return !stopped_;
  }
  operations::Reading sense(const std::string&) override {
    time += std::chrono::milliseconds(10);
    return {20.0, {}, stopped_.load()};
  }
  Duration now() const override { return time; }
  void stop() noexcept override {
    stopped_ = true;
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  }
  void allow() override { stopped_ = false; }

  void wait_until_inside() {
    std::unique_lock lock(mutex_);
    REQUIRE(changed_.wait_for(lock, std::chrono::seconds(5), [this] { return inside_; }));
  }
  void let_go() {
    const std::lock_guard lock(mutex_);
    held_ = false;
    changed_.notify_all();
  }
  void hold() {
    const std::lock_guard lock(mutex_);
    held_ = true;
  }

  std::atomic<int> runs = 0;
  std::chrono::microseconds lasts{0};  // a skill, on the wall
  Duration time{};

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool inside_ = false, held_ = true;
  std::atomic<bool> stopped_ = false;
};

inline operations::Skills clockwork_skills() {
  pan::Template quick;
  quick.name = "quick";
  pan::Parameter code;
  code.name = "code";
  code.type = pan::ScalarType::integer;
  code.high = 9;
  quick.parameters = {code};
  for (int i = 0; i < 10; ++i) {
    pan::Completion completion;
    completion.code = i;
    completion.kind = i == 0 ? pan::Completion::Kind::normal : pan::Completion::Kind::contingency;
    quick.completions.push_back(completion);
  }
  pan::Template lasting = quick;
  lasting.name = "long";
  return {{"quick", quick}, {"long", lasting}};
}

/// Two long skills and an end.
inline const char* const two_long =
    R"({"operation-format": 1, "name": "two", "icons": [{"id": "start", "kind": "start", "next": "a"},)"
    R"({"id": "a", "kind": "skill", "skill": "long", "next": "b", "error": "end"},)"
    R"({"id": "b", "kind": "skill", "skill": "long", "next": "end", "error": "end"}, {"id": "end", "kind": "exit"}]})";

/// Quick skills without end.
inline const char* const endless =
    R"({"operation-format": 1, "name": "endless", "icons": [{"id": "start", "kind": "start", "next": "a"},)"
    R"({"id": "a", "kind": "skill", "skill": "quick", "next": "a", "error": "end"}, {"id": "end", "kind": "exit"}]})";

/// Serves a desk in a thread of its own, as a cell does.
class Worker {
 public:
  explicit Worker(server::Desk& desk)
      : desk_(desk), thread_([&desk] {
          while (!desk.ended())
            if (!desk.work()) desk.wait(std::chrono::milliseconds(50));
        }) {}
  ~Worker() {
    desk_.end();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

 private:
  server::Desk& desk_;
  std::thread thread_;
};

}  // namespace pal::test
