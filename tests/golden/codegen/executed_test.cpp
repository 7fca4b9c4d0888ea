// The generated code of executed.pal, compiled and run. A module and those that it executes share their
// messages.
#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "executed_skill.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
namespace made = pal::skills::executed;

namespace {

/// What each activity was given, in the order of the run.
using Seen = std::vector<std::pair<const char*, double>>;

class Weigh final : public made::WeighActivities {
 public:
  explicit Weigh(Seen& seen) : seen_(seen) {}
  void before(const made::Load& load) override { seen_.emplace_back("before", load.value); }
  void after(const made::Load& load, const made::Verdict& verdict) override {
    seen_.emplace_back("after: load", load.value);
    seen_.emplace_back("after: verdict", verdict.value);
  }

 private:
  Seen& seen_;
};

class Judge final : public made::JudgeActivities {
 public:
  explicit Judge(Seen& seen) : seen_(seen) {}
  made::Verdict judge(const made::Load& load) override {
    seen_.emplace_back("judge", load.value);
    return {10 * load.value};
  }
  bool decide_heavy(const made::Load& load) override { return load.value > 6; }

 private:
  Seen& seen_;
};

class Note final : public made::NoteActivities {
 public:
  explicit Note(Seen& seen) : seen_(seen) {}
  void note(const made::Load& load, const made::Verdict& verdict) override {
    seen_.emplace_back("note: load", load.value);
    seen_.emplace_back("note: verdict", verdict.value);
  }

 private:
  Seen& seen_;
};

}  // namespace

TEST_CASE("an executed module and its caller share their messages") {
  Seen seen;
  const auto skill = made::make_executed(std::make_unique<Weigh>(seen), std::make_unique<Judge>(seen),
                                         std::make_unique<Note>(seen));
  double next = 4;
  ScriptedDevice scale("scale", {{"load", false, {{"value", "kg"}}}, {"request load", true, {}}});
  scale.on_receive = [&](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    const double load[] = {++next};
    host.deliver(0, load);
  };
  runtime::Device* devices[] = {&scale};
  const auto run = [&] {
    NoWorld world;
    return runtime::Dispatcher(devices, world).run(*skill, {}, {.horizon = 1s});
  };

  auto outcome = run();
  CHECK(outcome.reason == "The load is light.");
  CHECK(outcome.code == 0);
  CHECK(seen == Seen{{"before", 0},
                     {"judge", 5},
                     {"note: load", 6},
                     {"note: verdict", 50},
                     {"after: load", 6},
                     {"after: verdict", 50}});

  // The next run begins with nothing of the last one.
  seen.clear();
  outcome = run();
  CHECK(outcome.reason == "The load is heavy.");
  CHECK(outcome.code == 1);
  CHECK(seen == Seen{{"before", 0},
                     {"judge", 7},
                     {"note: load", 8},
                     {"note: verdict", 70},
                     {"after: load", 8},
                     {"after: verdict", 70}});
}
