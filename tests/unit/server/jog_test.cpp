// A client moves the arm by hand: who may, whose orders count, and what ends it.
#include <catch2/catch.hpp>

#include <future>

#include "tests/unit/server/support.hpp"

namespace pal::test {
namespace {

using namespace server;
using Why = Refusal::Why;

class NoSink final : public EventSink {
  void happened(const Event&) override {}
};

/// Lasts until it is let go or stopped, as the skill does.
class HandMoved final : public operations::SkillRunner, public Pendant {
 public:
  operations::SkillResult run(const std::string&, const std::vector<operations::Parameter>&,
                              std::optional<Duration>) override {
    std::unique_lock lock(mutex_);
    runs = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return stopped_ || released_; });
    runs = released_ = false;
    using Kind = operations::SkillResult::Kind;
    return stopped_ ? operations::SkillResult{Kind::stopped, 3, "stopped"}
                    : operations::SkillResult{Kind::normal, 0, ""};
  }
  void order(const JogAxes& axes, bool held) override {
    const std::lock_guard lock(mutex_);
    orders.push_back(axes);
    released_ = !held;
    changed_.notify_all();
  }
  void stop() noexcept override {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }
  void allow() override {
    const std::lock_guard lock(mutex_);
    stopped_ = false;
  }
  bool delay(Duration) override { return true; }
  operations::Reading sense(const std::string&) override { return {}; }
  Duration now() const override { return {}; }

  void wait_until_it_runs() {
    std::unique_lock lock(mutex_);
    REQUIRE(changed_.wait_for(lock, std::chrono::seconds(5), [this] { return runs; }));
  }

  bool runs = false;
  std::vector<JogAxes> orders;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopped_ = false, released_ = false;
};

operations::Skills jog_alone() {
  pan::Template jog;
  jog.name = "jog";
  for (const int code : {0, 1, 3}) {
    pan::Completion completion;
    completion.code = code;
    jog.completions.push_back(completion);
  }
  return {{"jog", jog}};
}

struct Cell {
  explicit Cell(bool by_hand = true) : desk(arm, jog_alone(), sink, options(by_hand)), worker(desk) {}

  DeskOptions options(bool by_hand) {
    DeskOptions result;
    if (by_hand) result.pendant = &arm;
    return result;
  }
  std::future<Reply> ask(ClientId client, Command command) {
    auto answer = std::make_shared<std::promise<Reply>>();
    desk.ask(client, std::move(command), [answer](const Reply& reply) { answer->set_value(reply); });
    return answer->get_future();
  }
  /// Why it was refused; nothing: it was obeyed.
  std::optional<Why> refused(ClientId client, Command command) {
    const Reply reply = ask(client, std::move(command)).get();
    const auto* refusal = std::get_if<Refusal>(&reply);
    return refusal == nullptr ? std::nullopt : std::optional(refusal->why);
  }
  static operations::SkillResult result(std::future<Reply>& answer) {
    REQUIRE(answer.wait_for(std::chrono::seconds(5)) == std::future_status::ready);
    return std::get<Done>(answer.get()).result;
  }

  NoSink sink;
  HandMoved arm;
  Desk desk;
  Worker worker;
};

using Kind = operations::SkillResult::Kind;

}  // namespace

TEST_CASE("orders count from the client that moves the arm, until it lets go") {
  Cell cell;
  const ClientId one = cell.desk.enter("one"), other = cell.desk.enter("other");
  CHECK(cell.refused(one, KeepJog{}) == Why::nothing);
  auto ends = cell.ask(one, StartJog{});
  cell.arm.wait_until_it_runs();
  CHECK(cell.refused(one, KeepJog{{0, 0, 1, 0, 0, 0}}) == std::nullopt);
  CHECK(cell.refused(other, KeepJog{{1, 0, 0, 0, 0, 0}}) == Why::nothing);
  CHECK(cell.refused(other, EndJog{}) == Why::nothing);
  CHECK(cell.refused(other, RunSkill{"jog", {}, false}) == Why::not_yours);
  CHECK(cell.refused(one, RunSkill{"jog", {}, false}) == Why::busy);
  CHECK(cell.refused(one, EndJog{}) == std::nullopt);
  CHECK(Cell::result(ends).kind == Kind::normal);
  REQUIRE(cell.arm.orders.size() == 2);
  CHECK(cell.arm.orders.front() == JogAxes{0, 0, 1, 0, 0, 0});
  CHECK(cell.refused(one, KeepJog{}) == Why::nothing);
}

TEST_CASE("a stop of anybody, a hold, and the client's going end a jog") {
  Cell cell;
  const ClientId looker = cell.desk.enter("looker", Role::viewer);
  const ClientId person = cell.desk.enter("person", Role::operating);
  const ClientId one = cell.desk.enter("one");
  auto ends = cell.ask(one, StartJog{});
  cell.arm.wait_until_it_runs();
  CHECK(cell.refused(looker, Stop{}) == std::nullopt);
  CHECK(Cell::result(ends).kind == Kind::stopped);
  ends = cell.ask(one, StartJog{});
  cell.arm.wait_until_it_runs();
  CHECK(cell.refused(person, SetHold{"look"}) == std::nullopt);
  CHECK(Cell::result(ends).kind == Kind::stopped);
  CHECK(cell.refused(one, StartJog{}) == Why::held);
  CHECK(cell.refused(one, ReleaseHold{}) == std::nullopt);
  ends = cell.ask(one, StartJog{});
  cell.arm.wait_until_it_runs();
  cell.desk.leave(one);
  CHECK(Cell::result(ends).kind == Kind::stopped);
}

TEST_CASE("only a programmer moves the arm by hand, and only where time goes by the clock") {
  Cell cell;
  for (const Role role : {Role::viewer, Role::operating}) {
    const ClientId client = cell.desk.enter("client", role);
    CHECK(cell.refused(client, StartJog{}) == Why::role);
    CHECK(cell.refused(client, KeepJog{}) == Why::role);
    CHECK(cell.refused(client, EndJog{}) == Why::role);
  }
  CHECK(cell.desk.can_jog());
  Cell fast(false);
  CHECK_FALSE(fast.desk.can_jog());
  CHECK(fast.refused(fast.desk.enter("one"), StartJog{}) == Why::absent);
}

}  // namespace pal::test
