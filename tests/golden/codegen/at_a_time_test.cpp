// The generated code of at_a_time.pal, compiled and run. Each block that executes a module with a CONCURRENT
// has its own threads for it.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "at_a_time_skill.hpp"
#include "tests/run/support/allocation_count.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
namespace made = pal::skills::at_a_time;

namespace {

class Mend final : public made::MendActivities {
 public:
  void start(const made::Parameters&) override { polished = 0; }
  void sand() override {}
  void polish() override { ++polished; }
  bool promise_broken(const runtime::BrokenPromise& broken) override {
    told.push_back(broken.promise);
    return true;
  }

  std::atomic<int> polished = 0;  // by several blocks at once, in real time (PAL0734)
  std::vector<std::string> told;
};

class Finish final : public made::FinishActivities {
 public:
  explicit Finish(const Mend& mend) : mend_(mend) {}
  made::Shine look() override { return {10.0 * mend_.polished}; }

 private:
  const Mend& mend_;
};

class Lamp final : public runtime::Device {
 public:
  Lamp() : ports_({{"shine", true, {{"level", "%"}}}}) {}
  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost&) override {}
  void open() override {}
  void receive(std::size_t, std::span<const double> fields) override { level = fields[0]; }
  void close() override { count_allocations(false); }

  double level = 0;

 private:
  std::string name_ = "lamp";
  std::vector<runtime::PortSpec> ports_;
};

/// Switches the counting on with the first event after the start.
class Meter final : public runtime::World {
 public:
  void advance_to(runtime::Time) override { count_allocations(true); }
};

using Told = std::vector<std::string>;

/// The events of one kind: when in microseconds, who, and at what.
Told told(const trace::Trace& trace, trace::Kind kind, const std::vector<std::string>& statements) {
  Told found;
  for (const trace::Event& event : trace.events) {
    if (event.kind != kind || event.statement < 0) continue;
    const std::string& text = trace.statements[static_cast<std::size_t>(event.statement)].text;
    if (std::find(statements.begin(), statements.end(), text) == statements.end()) continue;
    found.push_back(std::to_string(event.time_ns / 1000) + " " +
                    trace.actors[static_cast<std::size_t>(event.actor)].name + " " + text);
  }
  return found;
}

}  // namespace

TEST_CASE("blocks that execute one module at one time have their own threads in it") {
  auto mend = std::make_unique<Mend>();
  auto finish = std::make_unique<Finish>(*mend);
  const auto skill = made::make_at_a_time(std::move(finish), std::move(mend));
  Lamp lamp;
  Meter meter;
  runtime::Device* devices[] = {&lamp};
  for (int again = 0; again < 2; ++again) {
    reset_allocations();
    const auto outcome = runtime::Dispatcher(devices, meter).run(*skill, {}, {.horizon = 1s});
    CHECK(outcome.reason == "Smooth.");
    // What `pal check` proved of it when this was built: all times are fixed.
    CHECK(outcome.duration == 13700us);
    CHECK(lamp.level == 60);
    CHECK(counted_allocations() == 0);
    CHECK(told(outcome.trace, trace::Kind::done, {"sand", "polish", "look"}) ==
          Told{"1500 Finish.1/Mend.2 polish", "2000 Finish.3/Mend.1 sand", "2000 Finish.1/Mend.1 sand",
               "3000 Finish.3/Mend.2 polish", "3200 Finish.2 look", "4500 Finish.3/Mend.2 polish",
               "4700 Finish.2/Mend.2 polish", "5000 Finish.3/Mend.1 sand", "6500 Finish.3/Mend.2 polish",
               "6700 Finish.2/Mend.1 sand", "7000 Finish.3/Mend.1 sand", "8500 Mend.2 polish",
               "10500 Mend.1 sand", "13700 Finish look"});
    // The third block is stopped when the others have ended, after those that it has begun.
    CHECK(told(outcome.trace, trace::Kind::cancel, {"sand", "polish", "CONCURRENT"}) ==
          Told{"7000 Finish.3/Mend.1 sand", "7000 Finish.3 CONCURRENT"});
  }
}

TEST_CASE("a generated skill is told of a broken promise and of the requirements at risk") {
  auto owned = std::make_unique<Mend>();
  Mend& mend = *owned;
  auto finish = std::make_unique<Finish>(mend);
  const auto skill = made::make_at_a_time(std::move(finish), std::move(owned));
  Lamp lamp;
  NoWorld world;
  runtime::Device* devices[] = {&lamp};
  runtime::RunOptions options;
  options.on_broken_promise = runtime::OnBrokenPromise::contingency;
  for (const runtime::StatementSpec& statement : skill->wiring().statements) {
    if (statement.text == "polish") options.slow = {{"Mend", statement.line, 3ms}};
  }
  const auto outcome = runtime::Dispatcher(devices, world).run(*skill, {}, options);
  CHECK_FALSE(outcome.fault);
  REQUIRE(outcome.broken_promises.size() >= 2);
  const runtime::BrokenPromise& broken = outcome.broken_promises.front();
  CHECK(broken.promise.find("polish of Mend (at_a_time.pal:") == 0);
  CHECK(broken.by == "Finish.1/Mend.2");
  CHECK(broken.measured == 3ms);
  CHECK(broken.endangers == std::vector<std::string>{"in-time", "steady"});
  CHECK(outcome.broken_promises.back().promise == "requirement in-time, a duration of at most 13.7 ms");
  REQUIRE_FALSE(mend.told.empty());
  CHECK(mend.told.front() == broken.promise);
}

TEST_CASE("a generated skill runs in real time, its blocks at one time") {
  auto mend = std::make_unique<Mend>();
  auto finish = std::make_unique<Finish>(*mend);
  const auto skill = made::make_at_a_time(std::move(finish), std::move(mend));
  for (int again = 0; again < 3; ++again) {
    Lamp lamp;
    NoWorld world;
    runtime::Device* devices[] = {&lamp};
    const auto outcome = runtime::Dispatcher(devices, world)
                             .run(*skill, {}, {.horizon = 8s, .real_time = runtime::RealTime{}});
    CHECK(outcome.reason == "Smooth.");
    // The third block goes on until the others have ended; how far it comes is a matter of the machine.
    CHECK(lamp.level >= 30);
  }
}
