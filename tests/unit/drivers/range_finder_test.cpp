// The range finder: driver and emulator at the ends of a line, above shapes that can be calculated.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/devices/range_finder_emulator.hpp"
#include "tests/unit/drivers/session.hpp"

namespace pal::sim {
namespace {

using namespace std::chrono_literals;
using runtime::Time;
using runtime::drivers::RangeFinderDriver;
using runtime::drivers::Timeline;
using runtime::drivers::Wire;
namespace protocol = runtime::drivers::range_finder;

constexpr std::size_t request_profile = 0;
constexpr double degree = std::numbers::pi / 180;

/// A plane z = height + slope · y below the range finder, which moves along z. Lengths in m.
struct Surface {
  double height = 0.2;
  double slope = 0;
  double speed = 0;  // of the range finder towards the plane, m/s
};

struct Cell {
  explicit Cell(RangeFinderEmulatorOptions options = {.phase = 0ms, .error_scale = 0})
      : finder(timeline, wire.b(),
               {[this] { return pose(); }, [this](auto& o, auto& d) { return cast(o, d); }}, options) {
    session.begin();
  }
  Pose pose() const {
    const double moved = surface.speed * static_cast<double>(timeline.now().count()) * 1e-9;
    return Pose(Eigen::Translation3d(0, 0, moved));
  }
  std::optional<double> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    ++rays;
    const double closing = direction.z() - surface.slope * direction.y();
    const double distance = (surface.height - origin.z() + surface.slope * origin.y()) / closing;
    if (closing <= 0) return std::nullopt;
    return distance;
  }
  void run(Time time) { timeline.advance_to(timeline.now() + time); }
  /// The next profile that is asked for now.
  const std::vector<double>& read() {
    const std::size_t before = session.deliveries.size();
    driver.receive(request_profile, {});
    run(160ms);
    REQUIRE(session.faults == std::vector<std::string>{});
    REQUIRE(session.deliveries.size() == before + 1);
    return session.deliveries.back().fields;
  }
  /// The next scan that has not begun.
  Time next_scan() const {
    const Time since = timeline.now() - first_scan;
    return first_scan + protocol::period * (since / protocol::period + 1);
  }

  Timeline timeline;
  Wire wire{timeline, protocol::line};
  Surface surface;
  int rays = 0;
  RangeFinderEmulator finder;
  RangeFinderDriver driver{timeline, wire.a()};
  runtime::drivers::test::Session session{timeline, driver};
  // INIT has 5 bytes.
  const Time first_scan = protocol::line.duration(5) + 250ms;
};

double x(const std::vector<double>& fields, std::size_t i) {
  return fields[i];
}
double z(const std::vector<double>& fields, std::size_t i) {
  return fields[255 + i];
}
bool valid(const std::vector<double>& fields, std::size_t i) {
  return fields[510 + i] != 0;
}
double taken(const std::vector<double>& fields) {
  return fields[765];
}

TEST_CASE("range finder: 255 points over 40 degrees along y, in steps of 0.1 mm", "[range-finder]") {
  Cell cell;
  REQUIRE(cell.driver.trouble().empty());
  REQUIRE(cell.session.deliveries.empty());  // the first profile is thrown away
  cell.surface.slope = 0.1;
  const std::vector<double> fields = cell.read();
  REQUIRE(fields.size() == 766);
  for (std::size_t i = 0; i < 255; ++i) {
    INFO("point " << i);
    REQUIRE(valid(fields, i));
    const double tangent = std::tan((-20 + 40 * static_cast<double>(i) / 254) * degree);
    const double exact = 200 / (1 - 0.1 * tangent);
    REQUIRE(std::abs(z(fields, i) - exact) <= 0.0501);
    REQUIRE(std::abs(x(fields, i) - exact * tangent) <= 0.0501);
  }
}

TEST_CASE("range finder: a request before a scan begins is answered with it, 76 ms later", "[range-finder]") {
  Cell cell;
  SECTION("just before") {
    const Time scan = cell.next_scan();
    cell.timeline.advance_to(scan - 1us);
    cell.driver.receive(request_profile, {});
    cell.run(160ms);
    REQUIRE(cell.session.deliveries.size() == 1);
    CHECK(std::abs((cell.session.deliveries[0].time - (scan + 76ms)).count()) <= 10);
    CHECK(taken(cell.session.deliveries[0].fields) ==
          Approx(static_cast<double>(scan.count()) * 1e-6).margin(0.003));
  }
  SECTION("just after") {
    const Time scan = cell.next_scan();
    cell.timeline.advance_to(scan + 1us);
    cell.driver.receive(request_profile, {});
    cell.run(160ms);
    REQUIRE(cell.session.deliveries.size() == 1);
    CHECK(std::abs((cell.session.deliveries[0].time - (scan + 78ms + 76ms)).count()) <= 10);
  }
  // The scan was taken up no later than 0.2 ms after it began, and an unrequested scan casts no ray.
  REQUIRE(cell.session.marks.size() == 2);
  CHECK(cell.session.deliveries[0].time - cell.session.marks[0].first > 75800us);
  CHECK(cell.rays == 2 * 255);
}

TEST_CASE("range finder: no profile is lost if the next one is requested in the pause", "[range-finder]") {
  Cell cell;
  cell.driver.receive(request_profile, {});
  std::size_t seen = 0;
  while (seen < 20) {
    cell.run(500us);
    if (cell.session.deliveries.size() == seen) continue;
    ++seen;
    cell.driver.receive(request_profile, {});  // a courier: at once
  }
  for (std::size_t i = 1; i < 20; ++i) {
    const Time apart = cell.session.deliveries[i].time - cell.session.deliveries[i - 1].time;
    CHECK(std::abs((apart - 78ms).count()) <= 10);
  }
}

TEST_CASE("range finder: every second profile is lost if interpretation comes first", "[range-finder]") {
  Cell cell;
  cell.driver.receive(request_profile, {});
  std::size_t seen = 0;
  while (seen < 10) {
    cell.run(500us);
    if (cell.session.deliveries.size() == seen) continue;
    ++seen;
    cell.run(10ms);
    cell.driver.receive(request_profile, {});
  }
  for (std::size_t i = 1; i < 10; ++i) {
    const Time apart = cell.session.deliveries[i].time - cell.session.deliveries[i - 1].time;
    CHECK(std::abs((apart - 156ms).count()) <= 10);
  }
}

TEST_CASE("range finder: the arm moves while a scan lasts", "[range-finder]") {
  Cell cell;
  cell.surface.speed = 0.1;
  const std::vector<double> fields = cell.read();
  // 7.5 mm nearer from the first point to the last, in steps of 1 ms (0.1 mm) and of 0.1 mm.
  const double began = taken(fields);
  for (std::size_t i = 0; i < 255; ++i) {
    const double at = began + 0.05 + 76.0 / 255 * static_cast<double>(i);
    REQUIRE(std::abs(z(fields, i) - (200 - 0.1 * at)) <= 0.05 + 0.1 + 0.01);
  }
  CHECK(z(fields, 0) - z(fields, 254) == Approx(7.57).margin(0.21));
}

TEST_CASE("range finder: the first profile after INIT is not to be used", "[range-finder]") {
  Cell cell;
  const Time scan = cell.first_scan;
  struct Listener final : runtime::drivers::LinkUser {
    void on_bytes(runtime::drivers::Bytes bytes) override { seen += runtime::drivers::as_text(bytes); }
    void on_break(std::string_view) override {}
    std::string seen;
  } person;
  cell.surface.slope = 0.5;
  cell.wire.a().connect(&person);
  const auto type = [&](std::string_view text) { cell.wire.a().write(runtime::drivers::as_bytes(text)); };
  type("INIT\r");
  cell.run(100ms);
  type("PROFILE\r");  // the mirror does not swing yet
  cell.run(scan - 100ms - 10us);
  type("PROFILE\r");
  cell.run(20ms);
  type("PROFILE\r");
  cell.run(160ms);
  CHECK(person.seen.starts_with("? PROFILE\r\n\r\nREADY 255 0000250"));
  protocol::Codec codec;
  std::vector<protocol::Profile> profiles;
  for (const char c : person.seen) {
    if (codec.feed(static_cast<std::uint8_t>(c)) == protocol::Codec::Event::profile) {
      profiles.push_back(codec.profile());
    }
  }
  REQUIRE(profiles.size() == 2);
  const auto at = [](double angle) { return 200 / (1 + 0.5 * std::tan(angle * degree)); };
  CHECK(profiles[0].z[0] == Approx(at(20 * 0.7)).margin(0.2));  // the swing is still 30 % too small
  CHECK(profiles[1].z[0] == Approx(at(20)).margin(0.06));
}

TEST_CASE("range finder: the error at a distance is the stated one", "[range-finder]") {
  CHECK(range_error(100) == 0.1);
  CHECK(range_error(150) == 0.1);
  CHECK(range_error(250) == Approx(0.2));
  CHECK(range_error(850) == Approx(2));
  CHECK(range_error(1000) == Approx(20));
  for (const double height : {140.0, 250.0, 850.0}) {
    Cell cell{{.seed = 3}};
    cell.surface.height = height / 1000;
    const std::vector<double> fields = cell.read();
    double squares = 0, greatest = 0;
    for (std::size_t i = 0; i < 255; ++i) {
      const double error = std::abs(z(fields, i) - height);
      squares += error * error;
      greatest = std::max(greatest, error);
    }
    INFO("at " << height << " mm");
    CHECK(greatest <= range_error(height) + 0.0501);
    // Half the limit, its tails cut off at the limit, and steps of 0.1 mm.
    const double expected = std::hypot(range_error(height) / 2, 0.1 / std::sqrt(12.0));
    CHECK(std::sqrt(squares / 255) == Approx(expected).epsilon(0.2));
  }
}

TEST_CASE("range finder: what it cannot see is invalid", "[range-finder]") {
  Cell cell;
  SECTION("too near") {
    cell.surface.height = 0.09;
  }
  SECTION("too far") {
    cell.surface.height = 1.01;
  }
  SECTION("nothing there") {
    cell.surface.height = -0.1;
  }
  SECTION("too steep") {
    cell.surface.slope = 6;  // 80.5 degrees
    cell.surface.height = 0.3;
    const std::vector<double> fields = cell.read();
    // Where the ray leans towards the surface it meets it less steeply: 80.5 - 20 degrees at point 0.
    CHECK(valid(fields, 30));
    CHECK_FALSE(valid(fields, 127));
    return;
  }
  const std::vector<double> fields = cell.read();
  for (std::size_t i = 0; i < 255; ++i) {
    REQUIRE_FALSE(valid(fields, i));
    REQUIRE(z(fields, i) == 0);
  }
}

TEST_CASE("range finder: the same seed gives the same profiles and the same phase", "[range-finder]") {
  Cell cell{{.seed = 9}}, again{{.seed = 9}}, other{{.seed = 10}};
  CHECK(cell.read() == again.read());
  CHECK(cell.session.deliveries[0].time == again.session.deliveries[0].time);
  CHECK(cell.read() != other.read());
}

TEST_CASE("range finder: what goes wrong on the line ends the skill, in words", "[range-finder]") {
  Cell cell;
  std::string expected;
  SECTION("unplugged") {
    cell.driver.receive(request_profile, {});
    cell.run(20ms);
    cell.wire.cut("unplugged");
    expected = "the link is broken: unplugged";
  }
  SECTION("garbled") {
    cell.wire.tamper([](runtime::drivers::Carrier::Direction, std::vector<std::uint8_t>& bytes) {
      if (bytes.size() == 39) bytes[8] ^= 1U;  // of three points the first one's z
    });
    cell.driver.receive(request_profile, {});
    expected = "sends a profile whose check sum is wrong";
  }
  SECTION("dropout") {
    cell.driver.receive(request_profile, {});
    cell.run(cell.next_scan() + 10500us - cell.timeline.now());
    cell.wire.tamper(
        [](runtime::drivers::Carrier::Direction, std::vector<std::uint8_t>& bytes) { bytes.clear(); });
    expected =
        "only 34 of the 255 points of a profile came within 200 ms; is it switched on, and is its cable "
        "plugged in?";
  }
  SECTION("a request that is lost") {
    cell.wire.tamper(
        [](runtime::drivers::Carrier::Direction, std::vector<std::uint8_t>& bytes) { bytes.clear(); });
    cell.driver.receive(request_profile, {});
    expected = "no profile came within 200 ms; is it switched on, and is its cable plugged in?";
  }
  cell.run(300ms);
  CHECK(cell.session.faults == std::vector<std::string>{expected});
  CHECK(cell.driver.trouble() == expected);
  CHECK(cell.session.deliveries.empty());

  cell.driver.close();
  cell.wire.mend();
  cell.wire.tamper(nullptr);
  cell.session.faults.clear();
  cell.session.begin();
  CHECK(cell.driver.trouble().empty());
  cell.read();
}

TEST_CASE("range finder: a profile of the last session is not given to the next", "[range-finder]") {
  Cell cell;
  cell.driver.receive(request_profile, {});
  cell.run(100ms);
  cell.driver.close();
  runtime::drivers::test::Session next{cell.timeline, cell.driver};
  next.begin();
  REQUIRE(cell.driver.trouble().empty());
  cell.run(200ms);
  CHECK(next.deliveries.empty());
  CHECK(next.faults.empty());
}

}  // namespace
}  // namespace pal::sim
