// The generated code of survey.pal, compiled and run. A profile of 255 points and a text go from a device
// through a logical sensor's activity to the skill. From there they go to another device.
#include <catch2/catch.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/payload.hpp"
#include "survey_devices.hpp"
#include "survey_skill.hpp"
#include "tests/run/support/allocation_count.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
namespace made = pal::skills::survey;

namespace {

constexpr std::size_t points = 255;

/// Counts the points that are valid from the left; the seam is at the deepest of them.
class FindSeam final : public made::LS1Activities {
 public:
  made::Seam find_seam(const made::Profile& profile) override {
    made::Seam seam;
    seam.x = profile.x;
    seam.z = profile.z;
    for (std::size_t i = 0, valid = 0; i < points; ++i)
      seam.rank[i] = profile.valid[i] ? std::int64_t(++valid) : 0;
    seam.found = profile.taken > 0;
    seam.label = profile.label;
    return seam;
  }
};

class Aim final : public made::SM1Activities {
 public:
  void start(const made::Parameters& parameters) override { parameters_ = parameters; }
  bool decide_seen(const made::Seam& seam) override { return seam.found; }
  made::Go aim(const made::Seam& seam) override {
    std::size_t deepest = 0;
    for (std::size_t i = 0; i < points; ++i)
      if (seam.rank[i] > 0 && seam.z[i] < seam.z[deepest]) deepest = i;
    // The seam's name if it has one; no allocation: a Text is a value.
    const runtime::Text location = seam.label == "" ? parameters_.location : seam.label;
    return {location, {seam.x[deepest] + parameters_.offset, seam.z[deepest], double(seam.rank[deepest])}};
  }

 private:
  made::Parameters parameters_;
};

struct Point {
  double x = 0;
  double z = 0;
  bool valid = true;
};

/// A flank with a groove at 100; every tenth point is invalid, and lower than everything.
std::array<Point, points> groove() {
  std::array<Point, points> profile;
  for (std::size_t i = 0; i < points; ++i) {
    const double distance = i > 100 ? double(i - 100) : double(100 - i);
    profile[i] = {0.1 * double(i), distance / 3, true};
    if (i % 10 == 5) profile[i] = {0, -1000, false};
  }
  return profile;
}

using Fields = std::vector<runtime::FieldSpec>;
using runtime::FieldKind;

Fields profile_fields() {
  return {{"x", "mm", FieldKind::number, points},
          {"z", "mm", FieldKind::number, points},
          {"valid", "", FieldKind::number, points},
          {"taken", "ms"},
          {"label", "", FieldKind::text}};
}

Fields go_fields() {
  return {{"location", "", FieldKind::text}, {"depth", "mm", FieldKind::number, 3}};
}

/// Answers each request with the groove, and counts allocations from its first answer on.
class Finder final : public runtime::Device {
 public:
  explicit Finder(Fields fields = profile_fields())
      : ports_({{"request profile", true, {}}, {"profile", false, std::move(fields)}}) {}

  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost& host) override {
    host_ = &host;
    const auto profile = groove();
    for (std::size_t i = 0; i < points; ++i) {
      runtime::put(profile[i].x, numbers_, i);
      runtime::put(profile[i].z, numbers_, points + i);
      runtime::put(profile[i].valid, numbers_, 2 * points + i);
    }
    runtime::put(2.5, numbers_, 3 * points);
    runtime::put(label, numbers_, 3 * points + 1);
    if (spoil) numbers_[3 * points + 1] = *spoil;
  }
  void open() override {}
  void receive(std::size_t, std::span<const double>) override {
    host_->mark_busy(true);  // a device of a generated class does so by itself
    host_->at(host_->now() + 5ms, [this] {
      count_allocations(true);
      host_->mark_busy(false);
      host_->deliver(1, numbers_);
    });
  }
  void close() override {}

  runtime::Text label;
  std::optional<double> spoil;  // instead of the first number of the label

 private:
  std::string name_ = "finder";
  std::vector<runtime::PortSpec> ports_;
  std::array<double, 3 * points + 1 + runtime::Text::slots> numbers_{};
  runtime::DeviceHost* host_ = nullptr;
};

/// Keeps what it is told, and stops the counting.
class Robot final : public runtime::Device {
 public:
  explicit Robot(Fields fields = go_fields()) : ports_({{"go", true, std::move(fields)}}) {}

  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost&) override {}
  void open() override {}
  void receive(std::size_t, std::span<const double> fields) override {
    count_allocations(false);
    runtime::get(location, fields, 0);
    runtime::get(depth, fields, runtime::Text::slots);
  }
  void close() override { count_allocations(false); }

  runtime::Text location;
  std::array<double, 3> depth{};

 private:
  std::string name_ = "robot";
  std::vector<runtime::PortSpec> ports_;
};

/// The same two as a user writes them: from the generated classes.
class TypedFinder final : public made::FinderDevice {
 public:
  void attach(runtime::DeviceHost& host) override {
    FinderDevice::attach(host);
    const auto points_of_groove = groove();
    for (std::size_t i = 0; i < points; ++i) {
      profile_.x[i] = points_of_groove[i].x;
      profile_.z[i] = points_of_groove[i].z;
      profile_.valid[i] = points_of_groove[i].valid;
    }
    profile_.taken = 2.5;
    profile_.label = runtime::Text("seam 17");
  }

 private:
  void on_request_profile() override {
    after(answers_after.worst, [this] {
      count_allocations(true);
      send_profile(profile_);
    });
  }
  made::Profile profile_;
};

class TypedRobot final : public made::RobotDevice {
 public:
  made::Go went;

 private:
  void on_go(const made::Go& go) override {
    count_allocations(false);
    went = go;
  }
};

std::unique_ptr<runtime::Skill> make() {
  return made::make_survey(std::make_unique<Aim>(), std::make_unique<FindSeam>());
}

runtime::Outcome run(runtime::Device& finder, runtime::Device& robot,
                     std::vector<runtime::ParameterValue> parameters = {}) {
  const auto skill = make();
  runtime::Device* devices[] = {&finder, &robot};
  NoWorld world;
  return runtime::Dispatcher(devices, world).run(*skill, parameters, {.horizon = 1s});
}

}  // namespace

TEST_CASE("a profile and a text pass from a device through the skill to a device") {
  Finder finder;
  Robot robot;
  reset_allocations();
  SECTION("the text of the device") {
    finder.label = runtime::Text("seam 17, upper left edge");
    CHECK(run(finder, robot, {{.name = "location", .text = "home"}}).reason == "At the seam.");
    CHECK(robot.location == "seam 17, upper left edge");
  }
  SECTION("the text of the parameter") {
    CHECK(run(finder, robot, {{.name = "location", .text = "home"}, {"offset", 2}}).reason == "At the seam.");
    CHECK(robot.location == "home");
    CHECK(robot.depth[0] == 12);
  }
  SECTION("the default of the parameter") {
    CHECK(run(finder, robot).reason == "At the seam.");
    CHECK(robot.location == "park");
    CHECK(robot.depth[0] == 10.5);
  }
  CHECK(robot.depth[1] == 0);
  CHECK(robot.depth[2] == 91);  // of the points 0 to 100 these are valid
  CHECK(counted_allocations() == 0);
}

TEST_CASE("devices of generated classes act like those that write payloads by hand") {
  Finder finder;
  Robot robot;
  finder.label = runtime::Text("seam 17");
  const runtime::Outcome flat = run(finder, robot);
  TypedFinder typed_finder;
  TypedRobot typed_robot;
  reset_allocations();
  const runtime::Outcome typed = run(typed_finder, typed_robot);
  CHECK(counted_allocations() == 0);
  CHECK(typed.reason == "At the seam.");
  CHECK(typed.trace.events == flat.trace.events);
  CHECK(typed_robot.went.location == "seam 17");
  CHECK(typed_robot.went.location == robot.location);
  CHECK(typed_robot.went.depth == robot.depth);
}

TEST_CASE("a text that a device spoils ends the skill") {
  Finder finder;
  Robot robot;
  SECTION("no whole number") {
    finder.spoil = 0.5;
  }
  SECTION("too great") {
    finder.spoil = 281474976710656.0;
  }
  SECTION("negative") {
    finder.spoil = -1;
  }
  SECTION("no number") {
    finder.spoil = std::numeric_limits<double>::quiet_NaN();
  }
  SECTION("no printable character") {
    finder.spoil = 7;
  }
  SECTION("a character behind the end") {
    finder.spoil = 256.0 * 'a';
  }
  const auto outcome = run(finder, robot);
  CHECK(outcome.fault);
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.reason, Catch::Contains("delivers profile in a form that its port does not have"));
}

TEST_CASE("the ports of a device have the fields, kinds and sizes of the skill's messages") {
  const std::string wants =
      "device finder does not send profile with x[255] in mm, z[255] in mm, valid[255], taken in ms, "
      "label as a text: ";
  const auto refusal = [](Fields fields) {
    Finder finder(std::move(fields));
    Robot robot;
    const auto outcome = run(finder, robot);
    CHECK(outcome.fault);
    CHECK(outcome.duration == 0s);
    return outcome.reason;
  };
  Fields fields = profile_fields();
  SECTION("size") {
    fields[1].count = 128;
    CHECK(refusal(fields) == wants + "its z has 128 values, not 255");
  }
  SECTION("unit") {
    fields[0].unit = "cm";
    CHECK(refusal(fields) == wants + "its x is in cm, not in mm");
  }
  SECTION("no unit") {
    fields[3].unit = "";
    CHECK(refusal(fields) == wants + "its taken is a plain number, not in ms");
  }
  SECTION("kind") {
    fields[4].kind = FieldKind::number;
    CHECK(refusal(fields) == wants + "its label is a number, not a text");
  }
  SECTION("name") {
    fields[2].name = "good";
    CHECK(refusal(fields) == wants + "its field 3 is good, not valid");
  }
  SECTION("number of fields") {
    fields.pop_back();
    CHECK(refusal(fields) == wants + "its message has 4 fields, not 5");
  }
  SECTION("to the device") {
    Finder finder;
    Robot robot({{"location", "", FieldKind::number, 4}, {"depth", "mm", FieldKind::number, 3}});
    CHECK(run(finder, robot).reason ==
          "device robot does not take go with location as a text, depth[3] in mm: its location is a number, "
          "not "
          "a text");
  }
}

TEST_CASE("parameters that are texts are checked") {
  made::Parameters parameters;
  CHECK(parameters.location == "park");
  CHECK(parameters.suffix == "");
  CHECK(made::set_text_parameter(parameters, "location", "above the conveyor, left"));
  CHECK(parameters.location == "above the conveyor, left");
  CHECK(made::set_text_parameter(parameters, "location", ""));
  CHECK_FALSE(made::set_text_parameter(parameters, "place", "park"));
  CHECK_THROWS_WITH(made::set_text_parameter(parameters, "location", std::string(101, 'x')),
                    "parameter location has 101 characters; it may have up to 100");
  CHECK_THROWS_WITH(made::set_text_parameter(parameters, "location", "Caf\xC3\xA9"),
                    "parameter location may have printable characters of ASCII only");
  CHECK(parameters.location == "");

  const auto skill = make();
  CHECK_THROWS_WITH(skill->set_parameter("location", 5),
                    "parameter location is a text; it cannot be a number");
  CHECK_THROWS_WITH(skill->set_text_parameter("offset", "5"),
                    "parameter offset is a number; it cannot be a text");
  CHECK_THROWS_WITH(skill->set_text_parameter("place", "park"),
                    "skill survey has no parameter place; it has location, offset, suffix");
  Finder finder;
  Robot robot;
  const auto outcome = run(finder, robot, {{.name = "location", .text = "a\tb"}});
  CHECK(outcome.fault);
  CHECK(outcome.reason == "parameter location may have printable characters of ASCII only");
}
