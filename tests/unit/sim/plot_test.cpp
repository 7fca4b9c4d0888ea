#include "sim/report/plot.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/sim/profile_support.hpp"

using namespace pal::sim;
using namespace std::chrono_literals;

namespace {

std::vector<Sample> press() {
  std::vector<Sample> log;
  for (int i = 1; i <= 5000; ++i) {
    Sample sample;
    sample.time = i * 1ms;
    sample.set_point = {0.46, -0.2 + 1e-6 * i, -0.15 - 3e-6 * i};
    sample.tool = sample.set_point + Eigen::Vector3d(2e-5, 0, 0);
    sample.contact_force = i == 3210 ? 17 : i > 3000 ? 8 : 0;
    log.push_back(sample);
  }
  return log;
}

const std::string* file(const DrawnPlots& drawn, const std::string& name) {
  for (const auto& [known, content] : drawn.files)
    if (known == name) return &content;
  return nullptr;
}

}  // namespace

TEST_CASE("rows that are left out lose no peak and no dip") {
  std::vector<double> value(100'000);
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = std::sin(0.001 * static_cast<double>(i));
  value[777] = 9;
  value[55'555] = -9;
  const auto rows = telling_rows(value, 2000);
  CHECK(rows.size() <= 2001);
  CHECK(rows.size() > 1000);
  CHECK(std::is_sorted(rows.begin(), rows.end()));
  CHECK(std::count(rows.begin(), rows.end(), 777U) == 1);
  CHECK(std::count(rows.begin(), rows.end(), 55'555U) == 1);
  CHECK(telling_rows({3, 1, 2}, 2000) == std::vector<std::size_t>{0, 1, 2});
  CHECK(telling_rows({}, 2000).empty());
}

TEST_CASE("plots of a run: data, script and picture, the same each time") {
  const MessageLog messages;
  const std::vector<Plot> plots{
      force_plot(press(), messages, {"it's a press", {{"threshold", 5}}, {{"wanted", 6, 9}}, 4s}),
      position_plot(press(), "press", 4s), path_plot(press(), "press")};
  CHECK(plots[0].data[0].second.find("3.210,17.0000\n") != std::string::npos);
  CHECK(plots[0].script.find("'threshold 5 N'") != std::string::npos);
  CHECK(plots[0].script.find("'it''s a press'") != std::string::npos);
  CHECK(plots[1].data[0].second.find(
            "\n5.000,460.0000,-195.0000,-165.0000,460.0200,-195.0000,-165.0000,0.0200\n") !=
        std::string::npos);
  // It moved along z, and a little along y: x is looked along.
  CHECK(plots[2].script.find("set xlabel \"y, mm\"\nset ylabel \"z, mm\"") != std::string::npos);

  const DrawnPlots drawn = draw(plots);
  for (const char* name :
       {"force.csv", "force.gnuplot", "position.csv", "position.gnuplot", "path.csv", "path.gnuplot"})
    CHECK(file(drawn, name) != nullptr);
  if (!drawn.problem.empty()) {
    WARN("no plots here: " << drawn.problem);
    CHECK(drawn.problem.find("gnuplot") != std::string::npos);
    return;
  }
  for (const char* name : {"force.svg", "position.svg", "path.svg"}) {
    REQUIRE(file(drawn, name) != nullptr);
    CHECK(*file(drawn, name) == *file(draw(plots), name));
  }
  CHECK(file(drawn, "force.svg")->find(">threshold 5 N<") != std::string::npos);
  CHECK(file(drawn, "force.svg")->find(">it's a press<") != std::string::npos);
}

TEST_CASE("plots of range profiles with what was found in them") {
  RangeProfile profile = test::pyramid_profile(200);
  CHECK(std::any_of(profile.points.begin(), profile.points.end(), [](const auto& p) { return !p.valid; }));
  profile.lines = {{-50, 200, -30, 200}};
  profile.marks = {{"edge, left", -30, 200}};
  const Plot one = profile_plot(profile);
  CHECK(one.data.size() == 4);
  CHECK(one.script.find("set yrange [") != std::string::npos);
  const Plot four = profiles_plot({test::pyramid_profile(200), test::pyramid_profile(400)}, "pyramid");
  // A profile in which nothing was measured is a plot, too.
  const Plot nothing = profile_plot({"nothing", {{1, 0, false}}, {}, {}}, "nothing");
  const DrawnPlots drawn = draw({one, four, nothing});
  if (drawn.problem.find("not installed") != std::string::npos) return;
  CHECK(drawn.problem.empty());
  REQUIRE(file(drawn, "profile.svg") != nullptr);
  CHECK(file(drawn, "profile.svg")->find(">edge; left<") != std::string::npos);
  CHECK(file(drawn, "profiles.svg") != nullptr);
  CHECK(file(drawn, "nothing.svg") != nullptr);
}

TEST_CASE("without gnuplot there are data and scripts, and the reason") {
  const DrawnPlots missing = draw({path_plot(press(), "press")}, "gnuplot-that-is-not-there");
  CHECK(missing.problem == "gnuplot-that-is-not-there is not installed (apt-get install gnuplot-nox)");
  CHECK(missing.files.size() == 2);
  const DrawnPlots failing = draw({path_plot(press(), "press")}, "/bin/false");
  CHECK(failing.problem == "path: false ended with status 1");
  CHECK(failing.files.size() == 2);
}
