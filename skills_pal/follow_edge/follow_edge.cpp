#include "skills_pal/follow_edge/follow_edge.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "follow_edge_skill.hpp"
#include "runtime/drivers/alter/protocol.hpp"
#include "skills_pal/follow_edge/edge_map.hpp"
#include "skills_pal/follow_edge/literal_law.hpp"
#include "skills_pal/follow_edge/tool_step.hpp"
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/cycle_clock.hpp"
#include "skills_pal/modules/edge_slope.hpp"
#include "skills_pal/sensing/motion.hpp"

namespace pal::skills {

namespace {

using namespace follow_edge;

constexpr int lost_after = 5;  // profiles
constexpr double strays_from =
    3;  // mm beside where the edge is expected; along an edge it is seen within 1 mm
constexpr double interpreting = 3;  // ms from a profile's end until the skill knows the edge, in the mean
constexpr double part = 0.25;       // of what is missing that is corrected in a cycle
constexpr double cycles_a_profile =
    78.0 / std::chrono::duration<double, std::milli>(runtime::drivers::alter::period).count();
constexpr int cycles_to_move = 2;  // from a request to the end of the motion that was given at it

// The map takes a direction from four points of the edge in twice the history. Points are as far apart as the
// tool goes from profile to profile.
void refuse_short_history(double history, double track) {
  const double least = 1.5 * track * cycles_a_profile;
  if (history >= least) return;
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "at %g mm in 28 ms the edge is seen every %.1f mm: history must be %.1f mm or more, or the "
                "edge's direction "
                "is not known",
                track, track * cycles_a_profile, std::ceil(10 * least) / 10);
  throw runtime::ParameterError(text.data());
}

class Method final : public SM1Activities {
 public:
  explicit Method(std::shared_ptr<const MotionCount> obeyed) : obeyed_(std::move(obeyed)) {}

  void start(const Parameters& parameters) override {
    refuse_short_history(parameters.history, parameters.track);
    parameters_ = parameters;
    clock_.start();
    map_.start(parameters.history);
    goal_ = Eigen::Isometry3d::Identity();
    poses_.fill(goal_);
    gone_ = last_way_ = 0;
    goal_before_ = goal_;
    given_ = 0;
    last_at_ = -1;
    unseen_ = 0;
    strays_ = 0;
    law_.start({parameters.translation, parameters.rotation}, parameters.history, parameters.standoff * 10);
  }

  Motion track(const Edge& edge) override {
    take_back_what_was_dropped();
    clock_.tick();
    if (edge.at > last_at_) {
      last_at_ = edge.at;
      if (edge.seen) see(edge);
    }
    Motion motion = parameters_.literal ? about_the_edge(law_.take(), way()) : towards_edge();
    if (!parameters_.literal) motion.dx = way();
    last_way_ = way();
    gone_ += last_way_;
    if (parameters_.distance * 10 - gone_ < 1e-9) gone_ = parameters_.distance * 10;
    goal_before_ = goal_;
    goal_ = goal_ * moved_by(motion);
    ++given_;
    poses_[static_cast<std::size_t>(clock_.cycle()) % poses_.size()] = goal_;
    return motion;
  }

  Motion stand_still() override { return {}; }

  bool decide_pc_lost(const Edge& edge) override {
    unseen_ = edge.seen ? 0 : unseen_ + 1;
    return unseen_ >= lost_after || strays_ >= lost_after;
  }
  bool decide_pc_end() override { return gone_ >= parameters_.distance * 10; }

 private:
  // LS2 has the processor for up to 4 ms. A motion that is ready too late for its request is not made.
  void take_back_what_was_dropped() {
    if (given_ == obeyed_->load()) return;
    given_ = obeyed_->load();
    goal_ = goal_before_;
    gone_ -= last_way_;
    poses_[static_cast<std::size_t>(clock_.cycle()) % poses_.size()] = goal_;
  }

  // Where the tool was at an instant: the motion given at request k is made from request k + 1 to k + 2.
  Eigen::Isometry3d pose_at(double instant) const {
    sensing::ToolMotion motion;
    const int last = clock_.cycle() - 1;
    for (int cycle = std::max(0, last - static_cast<int>(poses_.size()) + 2); cycle <= last; ++cycle)
      motion.add(clock_.instant(cycle + cycles_to_move),
                 poses_[static_cast<std::size_t>(cycle) % poses_.size()]);
    return motion.empty() ? Eigen::Isometry3d::Identity() : motion.at(instant);
  }

  // Along the edge in this cycle: nothing before the edge was seen, or while the thesis's law still aligns.
  double way() const {
    if (parameters_.literal ? !law_.aligned() : map_.empty()) return 0;
    return std::min(parameters_.track, parameters_.distance * 10 - gone_);
  }

  void see(const Edge& edge) {
    // edge.at is of the one point; the profile's end is known from it well enough for the clock.
    clock_.saw(edge.at + sensing::scan_time / 2 + interpreting);
    const Eigen::Isometry3d pose = pose_at(edge.at);
    const double slope = edge.slope * degree;
    const Eigen::Vector3d point = pose * Eigen::Vector3d(0, edge.y, edge.z);
    strays_ = strays(point, pose.linear().col(0)) ? strays_ + 1 : 0;
    if (strays_ > 0) return;
    map_.add(point, pose.linear() * Eigen::Vector3d(0, std::cos(slope), std::sin(slope)));
    if (parameters_.literal) law_.see(edge.y, edge.z, edge.slope, gone_);
  }

  // Whether a point belongs to another edge. Where an edge ends, the range finder sees others beside it. The
  // thesis's law knows no map, and may be several mm off its edge.
  bool strays(const Eigen::Vector3d& point, const Eigen::Vector3d& heading) const {
    if (parameters_.literal) return false;
    const auto expected = map_.at(point, heading);
    return expected && (expected->point - point).norm() > strays_from;
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

  // The thesis's tool (appendix F.2) has its tip at the edge, a standoff away from the range finder: it turns
  // about that.
  Motion about_the_edge(const EdgeCorrection& correction, double along) const {
    Motion at_edge;
    at_edge.dx = along;
    at_edge.dy = correction.y;
    at_edge.dz = correction.z;
    at_edge.rx = correction.rx;
    at_edge.ry = correction.ry;
    at_edge.rz = correction.rz;
    const Eigen::Translation3d tip(0, 0, parameters_.standoff * 10);
    const Eigen::Vector3d way = (tip * moved_by(at_edge) * tip.inverse()).translation();
    Motion motion = at_edge;
    motion.dx = way.x();
    motion.dy = way.y();
    motion.dz = way.z();
    return motion;
  }

  static double limited(double value, double most) { return std::clamp(value, -most, most); }

  std::shared_ptr<const MotionCount> obeyed_;
  Parameters parameters_;
  CycleClock clock_;
  EdgeMap map_;
  Eigen::Isometry3d goal_ =
      Eigen::Isometry3d::Identity();         // where all motions lead, from where the skill began
  std::array<Eigen::Isometry3d, 16> poses_;  // the same after the motion of each cycle
  Eigen::Isometry3d goal_before_ = Eigen::Isometry3d::Identity();  // without the last motion
  double gone_ = 0;
  double last_way_ = 0;  // mm along the edge, of the last motion
  int given_ = 0;        // motions, without those that were dropped
  double last_at_ = -1;
  int unseen_ = 0;  // profiles without an edge, one after the other
  int strays_ = 0;  // profiles with another edge, one after the other
  LiteralLaw law_;
};

}  // namespace

std::unique_ptr<runtime::Skill> follow_edge_skill() {
  auto obeyed = std::make_shared<MotionCount>(0);
  return make_follow_edge(std::make_unique<Method>(obeyed), std::make_unique<EdgeSensor<LS2Activities>>(),
                          std::make_unique<AlterController<MC1Activities>>(Late::hold, obeyed));
}

}  // namespace pal::skills
