#include "skills_pal/follow_edge/follow_edge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "follow_edge_skill.hpp"
#include "skills_pal/follow_edge/edge_map.hpp"
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/cycle_clock.hpp"
#include "skills_pal/modules/edge_slope.hpp"
#include "skills_pal/sensing/motion.hpp"

namespace pal::skills {

namespace {

using namespace follow_edge;

constexpr double degree = std::numbers::pi / 180;
constexpr int lost_after = 5;       // profiles
constexpr double interpreting = 3;  // ms from a profile's end until the skill knows the edge, in the mean
constexpr double part = 0.25;       // of what is missing that is corrected in a cycle
constexpr int cycles_to_move = 2;   // from a request to the end of the motion that was given at it

Eigen::Isometry3d moved_by(const Motion& motion) {
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  step.translation() = Eigen::Vector3d(motion.dx, motion.dy, motion.dz);
  step.linear() = (Eigen::AngleAxisd(motion.rz * degree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(motion.ry * degree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(motion.rx * degree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return step;
}

class Method final : public SM1Activities {
 public:
  void start(const Parameters& parameters) override {
    parameters_ = parameters;
    clock_.start();
    map_.start(parameters.history);
    goal_ = Eigen::Isometry3d::Identity();
    poses_.fill(goal_);
    gone_ = 0;
    last_at_ = -1;
    unseen_ = 0;
    owed_ = {};
  }

  Motion track(const Edge& edge) override {
    clock_.tick();
    if (edge.at > last_at_) {
      last_at_ = edge.at;
      if (edge.seen) see(edge);
    }
    Motion motion = parameters_.literal ? literal_law() : towards_edge();
    // Nowhere to go before the edge was seen.
    const double left = parameters_.distance * 10 - gone_;
    motion.dx = map_.empty() ? 0 : std::min(parameters_.track, left);
    gone_ = left <= parameters_.track && !map_.empty() ? parameters_.distance * 10 : gone_ + motion.dx;
    goal_ = goal_ * moved_by(motion);
    poses_[static_cast<std::size_t>(clock_.cycle()) % poses_.size()] = goal_;
    return motion;
  }

  Motion stand_still() override { return {}; }

  bool decide_pc_lost(const Edge& edge) override {
    unseen_ = edge.seen ? 0 : unseen_ + 1;
    return unseen_ >= lost_after;
  }
  bool decide_pc_end() override { return gone_ >= parameters_.distance * 10; }

 private:
  // Where the tool was at an instant: the motion given at request k is made from request k + 1 to k + 2.
  Eigen::Isometry3d pose_at(double instant) const {
    sensing::ToolMotion motion;
    const int last = clock_.cycle() - 1;
    for (int cycle = std::max(0, last - static_cast<int>(poses_.size()) + 2); cycle <= last; ++cycle)
      motion.add(clock_.instant(cycle + cycles_to_move),
                 poses_[static_cast<std::size_t>(cycle) % poses_.size()]);
    return motion.empty() ? Eigen::Isometry3d::Identity() : motion.at(instant);
  }

  void see(const Edge& edge) {
    // edge.at is of the one point; the profile's end is known from it well enough for the clock.
    clock_.saw(edge.at + sensing::scan_time / 2 + interpreting);
    const Eigen::Isometry3d pose = pose_at(edge.at);
    const double slope = edge.slope * degree;
    map_.add(pose * Eigen::Vector3d(0, edge.y, edge.z),
             pose.linear() * Eigen::Vector3d(0, std::cos(slope), std::sin(slope)));
    if (parameters_.literal) owe(edge);
  }

  // What is missing between where all motions so far lead and where the edge is expected there.
  Motion towards_edge() const {
    Motion motion;
    const Eigen::Vector3d heading = goal_.linear().col(0);
    const auto place = map_.at(goal_.translation(), heading);
    if (!place) return motion;
    Eigen::Matrix3d wanted;
    const Eigen::Vector3d depth = place->along.cross(place->across).normalized();
    wanted << place->along, depth.cross(place->along), depth;
    const Eigen::Vector3d tip = place->point - parameters_.standoff * 10 * depth;
    const Eigen::Vector3d off = goal_.linear().transpose() * (tip - goal_.translation());
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(goal_.linear().transpose() * wanted));
    const Eigen::Vector3d about = turn.axis() * turn.angle() / degree;
    motion.dy = limited(part * off.y(), parameters_.translation);
    motion.dz = limited(part * off.z(), parameters_.translation);
    motion.rx = limited(part * about.x(), parameters_.rotation);
    motion.ry = limited(part * about.y(), parameters_.rotation);
    motion.rz = limited(part * about.z(), parameters_.rotation);
    return motion;
  }

  // Equations 5.1 to 5.7: each profile gives corrections, which are limited and given once.
  void owe(const Edge& edge) {
    owed_ = {};
    owed_.dy = edge.y;
    owed_.dz = edge.z - parameters_.standoff * 10;
    owed_.rx = edge.slope;
    const auto place = map_.at(goal_.translation(), goal_.linear().col(0));
    if (!place) return;
    const Eigen::Vector3d along = goal_.linear().transpose() * place->along;
    owed_.ry = -std::atan2(along.z(), along.x()) / degree;
    owed_.rz = std::atan2(along.y(), along.x()) / degree;
  }
  Motion literal_law() {
    Motion motion;
    motion.dy = limited(owed_.dy, parameters_.translation);
    motion.dz = limited(owed_.dz, parameters_.translation);
    motion.rx = limited(owed_.rx, parameters_.rotation);
    motion.ry = limited(owed_.ry, parameters_.rotation);
    motion.rz = limited(owed_.rz, parameters_.rotation);
    owed_ = {};
    return motion;
  }

  static double limited(double value, double most) { return std::clamp(value, -most, most); }

  Parameters parameters_;
  CycleClock clock_;
  EdgeMap map_;
  Eigen::Isometry3d goal_ =
      Eigen::Isometry3d::Identity();         // where all motions lead, from where the skill began
  std::array<Eigen::Isometry3d, 16> poses_;  // the same after the motion of each cycle
  double gone_ = 0;
  double last_at_ = -1;
  int unseen_ = 0;
  Motion owed_;
};

}  // namespace

std::unique_ptr<runtime::Skill> follow_edge_skill() {
  return make_follow_edge(std::make_unique<Method>(), std::make_unique<EdgeSensor<LS2Activities>>(),
                          std::make_unique<AlterController<MC1Activities>>());
}

}  // namespace pal::skills
