// The driver and the controller at the two ends of one wire.
#include "runtime/drivers/val/driver.hpp"

#include <catch2/catch.hpp>

#include "pal/runtime/payload.hpp"
#include "tests/unit/sim/val_support.hpp"

using namespace pal::sim;
using namespace pal::sim::val;
using namespace pal::sim::val::test;
using pal::runtime::Time;
using pal::runtime::drivers::ValDriver;
using pal::runtime::drivers::val::Answer;
using pal::runtime::drivers::val::Command;
using pal::runtime::drivers::val::Verb;
using DriverError = pal::runtime::drivers::val::Error;

namespace {

struct Driven : Bench {
  Driven() { wire.a().connect(&driver); }

  Answer ask(const Command& command, Time longest = 30s) {
    auto answer = std::make_shared<std::optional<Answer>>();  // may come later than this waits
    driver.submit(command, [answer](const Answer& given) { *answer = given; });
    const Time end = timeline.now() + longest;
    while (!*answer && timeline.now() < end) timeline.advance_to(std::min(timeline.next(), end));
    return answer->value_or(Answer::failed(DriverError::no_answer, "the driver did not answer"));
  }
  Answer ask(Verb verb, std::string location = {}, std::array<double, 6> figures = {},
             std::string second = {}) {
    return ask(Command{verb, std::move(location), std::move(second), figures});
  }

  ValDriver driver{timeline, wire.a()};
};

class Host final : public pal::runtime::DeviceHost {
 public:
  Time now() const override { return {}; }
  Appointment at(Time, std::function<void()>) override { return {}; }
  void cancel(Appointment) override {}
  bool deliver(std::size_t port, std::span<const double> fields) override {
    delivered.emplace_back(port, std::vector<double>(fields.begin(), fields.end()));
    return true;
  }
  void mark_busy(bool busy) override { marks.push_back(busy); }
  void fault(std::string) override {}
  std::vector<std::pair<std::size_t, std::vector<double>>> delivered;
  std::vector<bool> marks;
};

constexpr std::size_t text_slots = pal::runtime::Text::slots;
using Fields = std::array<double, 1 + 2 * text_slots + 6>;

Fields fields(Verb verb, std::string_view location = {}, double a = 0, double b = 0) {
  Fields numbers{};
  numbers[0] = static_cast<double>(verb);
  pal::runtime::put(pal::runtime::Text(location), numbers, 1);
  numbers[1 + 2 * text_slots] = a;
  numbers[2 + 2 * text_slots] = b;
  return numbers;
}

}  // namespace

TEST_CASE("VAL's driver: every command, answered by the controller") {
  Driven cell;
  CHECK(cell.ask(Verb::here, "A").ok);
  CHECK(cell.ask(Verb::set, "B", {}, "A").ok);
  CHECK(cell.ask(Verb::shift, "B", {0, 50, 0}).ok);
  CHECK(cell.ask(Verb::set_figures, "STEP", {0, 0, -10, 90, -90, 0}).ok);
  CHECK(cell.ask(Verb::speed, {}, {80}).ok);
  CHECK(cell.ask(Verb::straight_speed, {}, {200}).ok);
  for (const Verb verb : {Verb::move, Verb::move_straight}) CHECK(cell.ask(verb, "B").ok);
  for (const Verb verb : {Verb::approach, Verb::approach_straight}) CHECK(cell.ask(verb, "A", {20}).ok);
  for (const Verb verb : {Verb::depart, Verb::depart_straight}) CHECK(cell.ask(verb, {}, {-5}).ok);
  for (const Verb verb : {Verb::move_relative, Verb::straight_relative}) CHECK(cell.ask(verb, "STEP").ok);
  CHECK(cell.ask(Verb::joint_speed, {}, {100}).ok);
  CHECK(cell.ask(Verb::drive, {}, {6, 15, 100}).ok);
  CHECK(cell.ask(Verb::delay, {}, {0.5}).ok);
  CHECK(cell.ask(Verb::open_hand).ok);
  CHECK(cell.ask(Verb::close_hand).ok);
  CHECK(cell.ask(Verb::mode, {}, {2, 7}).ok);
  CHECK(cell.machine.store.reals["MODE2"] == 7);
  CHECK(cell.ask(Verb::tool, "STEP").ok);
  CHECK(cell.ask(Verb::base, {}, {0, 0, 10, 90}).ok);
  CHECK(cell.ask(Verb::base).ok);
  CHECK(cell.ask(Verb::configure, "FLIP").ok);
  CHECK(cell.ask(Verb::open_alter, {}, {3}).ok);
  CHECK(cell.alter.mode.world);
  CHECK(cell.ask(Verb::close_alter).ok);
  CHECK(cell.ask(Verb::calibrate).ok);
  CHECK(cell.ask(Verb::abort_process).ok);
  CHECK(cell.ask(Verb::abort).ok);
  CHECK(cell.ask(Verb::straight_to, {}, figures_of(cell.machine.here(cell.arm.joints()))).ok);
}

TEST_CASE("VAL's driver: figures come back") {
  Driven cell;
  const Answer where = cell.ask(Verb::where);
  REQUIRE(where.ok);
  const Figures tip = figures_of(cell.machine.here(PlainArm::start()));
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(where.values[i] == Approx(tip[i]).margin(i < 3 ? 0.0051 : 0.00051));
    CHECK(where.values[6 + i] == Approx(val_joints(PlainArm::start())[i]).margin(0.00051));
  }
  CHECK(cell.ask(Verb::set_figures, "P", {1, 2, 3.25, 40, 50, 60}).ok);
  const Answer point = cell.ask(Verb::point, "P");
  REQUIRE(point.ok);
  const std::array<double, 6> wanted{1, 2, 3.25, 40, 50, 60};
  for (std::size_t i = 0; i < 6; ++i) CHECK(point.values[i] == Approx(wanted[i]));
  const Answer none = cell.ask(Verb::point, "NOWHERE");
  CHECK(none.error == DriverError::undefined);
  CHECK(none.text == "Undefined value");
  CHECK(cell.ask(Verb::speed, {}, {50}).ok);  // and goes on
}

TEST_CASE("VAL's driver: errors say what they are") {
  Driven cell;
  CHECK(cell.ask(Verb::move, "NOWHERE").error == DriverError::undefined);
  CHECK(cell.ask(Verb::straight_to, {}, {2000, 0, 0, 0, 0, 0}).error == DriverError::unreachable);
  CHECK(cell.ask(Verb::speed, {}, {500}).error == DriverError::refused);
  CHECK(cell.driver.last_error() == "Illegal speed above 0 to 100 is wanted");
  CHECK(cell.ask(Verb::move, "not a name").error == DriverError::refused);
  cell.arm.break_down("the forearm hit post 2");
  CHECK(cell.ask(Verb::ready).error == DriverError::arm_fault);
  CHECK(cell.ask(Verb::calibrate).ok);
  cell.machine.attached = true;
  CHECK(cell.ask(Verb::ready).error == DriverError::busy);
}

TEST_CASE("VAL's driver: EXECUTE does not wait, CLEAR takes its answer, announcements are passed over") {
  Driven cell;
  cell.machine.store.programs["PROG1"] = {"DELAY 0.02"};
  const Time begin = cell.timeline.now();
  CHECK(cell.ask(Verb::execute, {}, {1, 1}).ok);
  CHECK(cell.timeline.now() - begin < 800ms);
  // The program ends at any point of the commands that follow; they are answered all the same.
  for (int delay = 0; delay < 60; ++delay) {
    CHECK(cell.ask(Verb::clear).ok);
    CHECK(cell.ask(Verb::speed, {}, {50}).ok);
    cell.machine.store.programs["PROG1"] = {"DELAY 0.0" + std::to_string(10 + delay)};
    CHECK(cell.ask(Verb::execute, {}, {1, 1}).ok);
    CHECK(cell.ask(Verb::move, "NOWHERE").error == DriverError::undefined);
    CHECK(cell.ask(Verb::where).ok);
    cell.timeline.advance_to(cell.timeline.now() + 300ms);
  }
  CHECK(cell.ask(Verb::execute, {}, {9, 1}).ok);
  CHECK(cell.ask(Verb::clear).error == DriverError::undefined);
  CHECK(cell.ask(Verb::clear).ok);  // nothing is owed
}

TEST_CASE("VAL's driver: a garbled line is not carried out, and sent again") {
  Driven cell;
  REQUIRE(cell.ask(Verb::speed, {}, {10}).ok);
  int garble = 1;
  cell.wire.tamper([&](pal::runtime::drivers::Carrier::Direction to, std::vector<std::uint8_t>& bytes) {
    if (to == pal::runtime::drivers::Carrier::Direction::to_b && bytes.size() > 5 && garble-- > 0)
      bytes.back() = '9';
  });
  CHECK(cell.ask(Verb::speed, {}, {20}).ok);
  CHECK(cell.machine.monitor_speed == 20);
  garble = 100;
  const Answer answer = cell.ask(Verb::speed, {}, {30});
  CHECK(answer.error == DriverError::no_answer);
  CHECK(answer.text == "VAL's echo is garbled");
  CHECK(cell.machine.monitor_speed == 20);
  garble = 0;
  CHECK(cell.ask(Verb::speed, {}, {40}).ok);
  CHECK(cell.machine.monitor_speed == 40);
}

TEST_CASE("VAL's driver: what does not answer, and what is unplugged") {
  Driven cell;
  REQUIRE(cell.ask(Verb::speed, {}, {10}).ok);
  bool deaf = true;
  cell.wire.tamper([&](pal::runtime::drivers::Carrier::Direction, std::vector<std::uint8_t>& bytes) {
    if (deaf) bytes.clear();
  });
  CHECK(cell.ask(Verb::where).text == "VAL does not answer");
  CHECK(cell.ask(Verb::where).text == "VAL does not answer");
  CHECK(cell.driver.trouble() == "VAL does not answer");
  deaf = false;
  CHECK(cell.ask(Verb::where).ok);
  CHECK(cell.driver.trouble().empty());

  std::optional<Answer> answer;
  cell.driver.submit({Verb::delay, {}, {}, {5}}, [&](const Answer& given) { answer = given; });
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  cell.wire.cut("unplugged");
  REQUIRE(answer);
  CHECK(answer->text == "line to VAL broken: unplugged");
  CHECK(cell.ask(Verb::where).error == DriverError::no_answer);
  cell.wire.mend();
  cell.driver.prepare();
  while (!cell.driver.ready()) cell.timeline.advance_to(cell.timeline.next());
  CHECK(cell.driver.trouble().empty());
  CHECK(cell.ask(Verb::where).ok);
}

TEST_CASE("VAL's driver: a motion that takes too long is aborted") {
  Driven cell;
  ValDriver hasty(cell.timeline, cell.wire.a(), {.motion_within = 500ms});
  std::optional<Answer> answer;
  hasty.submit({Verb::here, "A", {}, {}}, [&](const Answer& given) { answer = given; });
  cell.timeline.advance_to(cell.timeline.now() + 5s);
  REQUIRE(answer);
  CHECK(answer->ok);
  answer.reset();
  hasty.submit({Verb::ready, {}, {}, {}}, [&](const Answer& given) { answer = given; });
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  REQUIRE(answer);
  CHECK(answer->text == "no answer to DO READY");
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  CHECK(cell.arm.at_rest());
  hasty.submit({Verb::where, {}, {}, {}}, [&](const Answer& given) { answer = given; });
  cell.timeline.advance_to(cell.timeline.now() + 5s);
  CHECK(answer->ok);
  cell.wire.a().connect(nullptr);
}

TEST_CASE("VAL's driver as a device: ports, answers, an end during a motion") {
  Driven cell;
  Host host;
  const auto& ports = cell.driver.ports();
  REQUIRE(ports.size() == 3);
  CHECK(ports[0].message == "command");
  CHECK(ports[0].to_device);
  CHECK(ports[1] == pal::runtime::PortSpec{"request answer", true, {}});
  CHECK(ports[2].message == "answer");
  CHECK_FALSE(cell.driver.ready());
  cell.driver.prepare();
  while (!cell.driver.ready()) cell.timeline.advance_to(cell.timeline.next());
  CHECK(cell.driver.trouble().empty());
  cell.driver.attach(host);
  cell.driver.open();
  const auto ask = [&](const Fields& command) {
    cell.driver.receive(0, command);
    cell.driver.receive(1, {});
  };
  ask(fields(Verb::here, "A"));
  ask(fields(Verb::drive, {}, 9, 1));
  cell.timeline.advance_to(cell.timeline.now() + 2s);
  REQUIRE(host.delivered.size() == 2);
  CHECK(host.marks == std::vector<bool>{true, false, true, false});
  CHECK(host.delivered[0].first == 2);
  REQUIRE(host.delivered[0].second.size() == 2 + text_slots + 12);
  CHECK(host.delivered[0].second[0] == 1);
  CHECK(host.delivered[1].second[0] == 0);
  CHECK(host.delivered[1].second[1] == static_cast<double>(DriverError::refused));
  pal::runtime::Text text;
  pal::runtime::get(text, host.delivered[1].second, 2);
  CHECK(text.view() == "Illegal value 1 to 6 is wanted");

  ask(fields(Verb::speed, {}, 10));
  ask(fields(Verb::ready));
  ask(fields(Verb::move, "A"));
  CHECK(cell.driver.withdraw(1));
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  CHECK_FALSE(cell.arm.at_rest());
  CHECK_FALSE(cell.driver.withdraw(1));
  cell.driver.close();
  CHECK_FALSE(cell.driver.ready());
  while (!cell.driver.ready()) cell.timeline.advance_to(cell.timeline.next());
  CHECK(cell.driver.trouble().empty());
  CHECK(cell.arm.at_rest());
  CHECK(host.delivered.size() == 3);

  // An answer to nothing. It comes no sooner than a line could have brought it.
  cell.driver.attach(host);
  cell.driver.receive(1, {});
  cell.timeline.advance_to(cell.timeline.now() + 20ms - 1ns);
  CHECK(host.delivered.size() == 3);
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  REQUIRE(host.delivered.size() == 4);
  CHECK(host.delivered[3].second[1] == static_cast<double>(DriverError::refused));
  cell.driver.close();

  // A program that the skill began does not outlive it.
  cell.machine.store.programs["PROG1"] = {"DELAY 100"};
  cell.driver.attach(host);
  ask(fields(Verb::execute, {}, 1, -1));
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  CHECK(cell.machine.attached);
  cell.driver.close();
  cell.timeline.advance_to(cell.timeline.now() + 2s);
  CHECK_FALSE(cell.machine.attached);
}

TEST_CASE("VAL's driver as a device: a broken line is answered, no sooner than others") {
  Driven cell;
  Host host;
  cell.driver.attach(host);
  cell.driver.receive(0, fields(Verb::delay, {}, 5));
  cell.driver.receive(1, {});
  cell.timeline.advance_to(cell.timeline.now() + 1s);
  cell.wire.cut("unplugged");
  REQUIRE(host.delivered.size() == 1);
  CHECK(host.delivered[0].second[1] == static_cast<double>(DriverError::no_answer));
  cell.driver.receive(0, fields(Verb::where));
  cell.driver.receive(1, {});
  cell.timeline.advance_to(cell.timeline.now() + 20ms - 1ns);
  CHECK(host.delivered.size() == 1);
  cell.timeline.advance_to(cell.timeline.now() + 1ns);
  REQUIRE(host.delivered.size() == 2);
  CHECK(host.marks == std::vector<bool>{true, false, true, false});
}

TEST_CASE("VAL's driver: how long a command takes follows from the line and the controller") {
  Driven cell;
  REQUIRE(cell.ask(Verb::speed, {}, {10}).ok);
  const Time begin = cell.timeline.now();
  REQUIRE(cell.ask(Verb::speed, {}, {50}).ok);
  // "SPEED 50" there and back, Return, 5 ms of VAL's (the echo of Return is shorter), the prompt.
  const Time wanted = cell.wire.speed().duration(8 + 8 + 1) + 5ms + cell.wire.speed().duration(1);
  CHECK(std::abs((cell.timeline.now() - begin - wanted).count()) <= 5);

  // WHERE: an echo of 5, Return, four lines and the prompt.
  const Time asked = cell.timeline.now();
  REQUIRE(cell.ask(Verb::where).ok);
  const Time shown = cell.wire.speed().duration(5 + 5 + 1) + 5ms + cell.wire.speed().duration(217 + 1);
  CHECK(std::abs((cell.timeline.now() - asked - shown).count()) <= 5);
}
