// What the logical sensors make of the range finder's profiles, beside what is there.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/station.hpp"
#include "sim/cell/device_views.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/devices/range_finder_emulator.hpp"
#include "skills_pal/sensing/edge.hpp"
#include "skills_pal/sensing/nearest_point.hpp"
#include "tests/benchmark/workcell/row.hpp"

namespace pal::bench {
namespace {

using namespace std::chrono_literals;

/// Takes profiles in a scene, by the range finder's bytes. Lengths in mm.
class Viewing final : private runtime::DeviceHost {
 public:
  explicit Viewing(const sim::Scene& scene)
      : workcell_(scene, {.keep_log = false}),
        station_(workcell_),
        wire_(station_.timeline(), runtime::drivers::range_finder::line),
        finder_(station_.timeline(), wire_.b(), sim::range_view(workcell_)),
        driver_(station_.timeline(), wire_.a()) {
    driver_.attach(*this);
    driver_.prepare();
    while (!driver_.ready()) station_.idle(10ms);
  }

  void go(double x, double y, double z) {
    sim::Pose goal = workcell_.set_point();
    goal.translation() = 1e-3 * Eigen::Vector3d(x, y, z);
    if (workcell_.motion().move_straight(goal, {}, workcell_.now()))
      throw std::runtime_error("a motion is refused");
    while (!workcell_.idle()) station_.idle(sim::alter_period);
    station_.idle(200ms);
  }

  /// Valid until the next one.
  skills::sensing::Profile profile() {
    came_ = false;
    driver_.receive(0, {});
    while (!came_) station_.idle(10ms);
    return {std::span(fields_).first(255), std::span(fields_).subspan(255, 255), valid_};
  }
  const sim::Workcell& workcell() const { return workcell_; }

 private:
  runtime::Time now() const override { return station_.now(); }
  Appointment at(runtime::Time, std::function<void()>) override { return {}; }
  void cancel(Appointment) override {}
  bool deliver(std::size_t, std::span<const double> fields) override {
    std::copy_n(fields.begin(), fields_.size(), fields_.begin());
    std::transform(fields.begin() + 510, fields.begin() + 765, valid_.begin(),
                   [](double value) { return value != 0; });
    return came_ = true;
  }
  void mark_busy(bool) override {}
  void fault(std::string reason) override { throw std::runtime_error(reason); }

  sim::Workcell workcell_;
  runtime::drivers::Station station_;
  runtime::drivers::Wire wire_;
  sim::RangeFinderEmulator finder_;
  runtime::drivers::RangeFinderDriver driver_;
  bool came_ = false;
  std::array<double, 510> fields_{};
  std::array<bool, 255> valid_{};
};

/// The nearest point over a flat plate, from 150 to 450 mm: the greatest error, as a part of the stated one.
double standoff() {
  constexpr double top = -300;  // mm: so low that the arm reaches 450 mm above it
  const std::string file =
      (std::filesystem::temp_directory_path() / fmt::format("bench-{}.scene", ::getpid())).string();
  std::ofstream(file) << "no table\ntool range-finder\nstart 480 -200 0\nplate at 480 -200 " << top - 15
                      << " size 400 400 15\n";
  Viewing view({"deep", file});
  std::filesystem::remove(file);
  double worst = 0;
  for (double distance = 150; distance <= 450; distance += 50) {
    view.go(480, -200, top + distance);
    for (int i = 0; i < 20; ++i) {
      const auto nearest = skills::sensing::find_nearest_point(view.profile());
      if (!nearest) throw std::runtime_error("no nearest point");
      // What its ray meets, by the pose at which the arm truly is.
      const sim::Pose pose = view.workcell().tool();
      const Eigen::Vector3d ray(0, nearest->y, nearest->z);
      const auto met = view.workcell().cast(pose.translation(), pose.linear() * ray.normalized());
      if (!met) throw std::runtime_error("nothing is where the nearest point is");
      const double there = *met * 1e3 * nearest->z / ray.norm();
      worst = std::max(worst, std::abs(nearest->z - there) / sim::range_error(there));
    }
  }
  return worst;
}

/// Of the edge of scene block-edges at y = -200, seen from 200 mm; mm.
double edge_rms() {
  constexpr double top = -121.8, distance = 200, edge_at = -200;
  constexpr int places = 20, each = 10;
  Viewing view(sim::find_scene("block-edges", {PAL_SCENE_DIR}));
  double squares = 0;
  for (int place = 0; place < places; ++place) {
    view.go(480, edge_at + 30.0 * (place + 0.5) / places - 15, top + distance);
    for (int i = 0; i < each; ++i) {
      const skills::sensing::Profile profile = view.profile();
      const auto edge = skills::sensing::find_edge(profile);
      if (!edge) throw std::runtime_error("an edge is not found");
      const Eigen::Vector3d found =
          1e3 * (view.workcell().tool() * Eigen::Vector3d(0, edge->y * 1e-3, edge->z * 1e-3));
      squares += (found.y() - edge_at) * (found.y() - edge_at);
    }
  }
  return std::sqrt(squares / (places * each));
}

}  // namespace

std::vector<Row> range_rows() {
  const double part = standoff(), rms = edge_rms();
  return {{"nearest point, 150 to 450 mm: greatest error by the stated", fmt::format("{:.0f} %", 100 * part),
           "at most 50 %", part <= 0.5},
          {"edge by two lines at 200 mm, 200 profiles", fmt::format("{:.3f} mm rms", rms), "at most 0.2 mm",
           rms <= 0.2}};
}

}  // namespace pal::bench
