#include "sim/report/log_table.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "tests/unit/sim/support.hpp"

using namespace pal;
using namespace pal::sim;
using namespace std::chrono_literals;

namespace {

class Echo final : public runtime::Device {
 public:
  Echo() = default;
  explicit Echo(std::vector<runtime::PortSpec> ports) : ports_(std::move(ports)) {}
  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(runtime::DeviceHost&) override {}
  void open() override {}
  void receive(std::size_t, std::span<const double>) override {}
  void close() override {}

 private:
  std::string name_ = "echo";
  std::vector<runtime::PortSpec> ports_{
      {"push", true, {{"dz", "mm"}}}, {"answer", false, {{"count", ""}}}, {"go", true, {}}};
};

std::vector<std::vector<std::string>> table(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

}  // namespace

TEST_CASE("the log has what was commanded and read up to each millisecond") {
  const Echo echo;
  MessageLog messages;
  messages.passed(1500us, echo, 0, std::array{3.5});
  messages.passed(3500us, echo, 1, std::array{7.0});
  messages.passed(4ms, echo, 2, {});  // without fields: the trace has it
  REQUIRE(messages.size() == 2);

  std::vector<Sample> log(4);
  for (std::size_t i = 0; i < 4; ++i) log[i].time = static_cast<int>(i + 1) * 1ms;
  log[1].joints[2] = M_PI / 2;
  log[1].tool = {0.1, -0.2, 0.3};
  log[1].tool_turn = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
  log[1].wrench.force.z() = -4.25;
  log[1].contact_force = 4.5;
  const auto rows = table(log_table(log, messages));
  REQUIRE(rows.size() == 5);
  for (const auto& row : rows) CHECK(row.size() == rows[0].size());
  const auto cell = [&](std::size_t row, const std::string& column) {
    for (std::size_t i = 0; i < rows[0].size(); ++i)
      if (rows[0][i] == column) return rows[row][i];
    return "there is no column " + column;
  };
  CHECK(cell(2, "time_ms") == "2");
  CHECK(cell(2, "joint3_deg") == "90.00000");
  CHECK(cell(2, "tool_y_mm") == "-200.0000");
  CHECK(cell(2, "tool_rx_deg") == "180.00000");
  CHECK(cell(2, "wrench_fz_N") == "-4.2500");
  CHECK(cell(2, "contact_force_N") == "4.5000");
  CHECK(cell(1, "echo.push.dz_mm").empty());
  CHECK(cell(2, "echo.push.dz_mm") == "3.5");
  CHECK(cell(3, "echo.answer.count").empty());
  CHECK(cell(4, "echo.answer.count") == "7");
}

TEST_CASE("turn angles are those of a correction") {
  for (const Correction& turn :
       {Correction{.rx = 10, .ry = 20, .rz = -30}, Correction{.rx = 179, .ry = -5, .rz = 90}}) {
    const Pose pose = corrected(Pose::Identity(), turn, CorrectionFrame::world, Pose::Identity());
    const Eigen::Vector3d angles = turn_angles(Eigen::Quaterniond(pose.linear()));
    CHECK((angles - Eigen::Vector3d(turn.rx, turn.ry, turn.rz)).norm() < 1e-9);
  }
}

TEST_CASE("an array has no column, and does not shift those after it") {
  const Echo echo({{"profile", false, {{"x", "mm", runtime::FieldKind::number, 3}, {"taken", "ms"}}}});
  MessageLog messages;
  messages.passed(1ms, echo, 0, std::array{1.5, 2.5, 3.5, 42.0});
  std::vector<Sample> log(1);
  log[0].time = 1ms;
  const auto rows = table(log_table(log, messages));
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].back() == "echo.profile.taken_ms");
  CHECK(rows[1].back() == "42");
  CHECK(std::find(rows[0].begin(), rows[0].end(), "echo.profile.x_mm") == rows[0].end());
  CHECK(rows[0].size() == rows[1].size());
}
