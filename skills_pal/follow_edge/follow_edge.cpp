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
// mm beside where the edge is expected; along an edge it is seen within 1 mm. A tool that is as far from
// where it should be above the edge cannot tell it from another one.
constexpr double strays_from = 3;
// The thesis's law looks at every second profile while it aligns, and may be several mm off.
constexpr double strays_from_literal = 6;
// mm and deg: so near the edge the tool begins to go along it.
constexpr double beside_edge = 1, square_to_it = 2;
// Profiles within which the tool must come nearer to the edge by `nearer` mm while it aligns.
constexpr int patience = 60;
constexpr double nearer = 0.3;
// So far off the tool may be when it begins, mm and deg.
constexpr double farthest_off = 400, most_askew = 45;
// s, for a step of the correction while the tool aligns: twice a cycle. The thesis's law makes a step for
// every second profile.
constexpr double for_a_step = 0.056, for_a_step_literal = 0.156;
constexpr double to_settle = 10;  // s
// mm in a cycle: what turning about the edge may add to the range finder's way.
constexpr double most_swing = 3.5;
constexpr double interpreting = 3;  // ms from a profile's end until the skill knows the edge, in the mean
constexpr double part = 0.25;       // of what is missing that is corrected in a cycle
constexpr double cycle =            // ms
    std::chrono::duration<double, std::milli>(runtime::drivers::alter::period).count();
constexpr double cycles_a_profile = 78.0 / cycle;
constexpr int cycles_to_move = 2;  // from a request to the end of the motion that was given at it

// The map takes a direction from four points of the edge in twice the history. Points are as far apart as the
// tool goes from profile to profile.
void refuse_short_history(double history, double track) {
  const double least = 1.5 * track * cycles_a_profile;
  if (history >= least) return;
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "at %g mm in %g ms the edge is seen every %.1f mm: history must be %.1f mm or more, or the "
                "edge's direction is not known",
                track, cycle, track * cycles_a_profile, std::ceil(10 * least) / 10);
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
    aligned_ = false;
    off_ = 0;
    least_off_ = 1e9;
    since_nearer_ = 0;
    far_off_ = aligning_ = 0;
    most_turn_ = std::min(parameters.rotation, most_swing / (parameters.standoff * 10) / degree);
    most_aligning_ = static_cast<int>(1000 / cycle * time_to_align());
    law_.start({parameters.translation, most_turn_}, parameters.history, parameters.standoff * 10);
  }

  Motion track(const Edge& edge) override {
    take_back_what_was_dropped();
    clock_.tick();
    if (!aligned()) ++aligning_;
    if (edge.at > last_at_) {
      last_at_ = edge.at;
      if (edge.seen) see(edge);
    }
    const Motion motion = about_the_edge(parameters_.literal ? law_.take() : towards_edge(), way());
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
    return unseen_ >= lost_after || strays_ >= lost_after || far_off_ >= lost_after ||
           since_nearer_ >= patience || aligning_ > most_aligning_;
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

  bool aligned() const { return parameters_.literal ? law_.aligned() : aligned_; }
  // At the most, s: follow_edge.declared says no more.
  double time_to_align() const {
    const double each = parameters_.literal ? for_a_step_literal : for_a_step;
    return each * (farthest_off / parameters_.translation + most_askew / most_turn_) + to_settle;
  }

  // Along the edge in this cycle: nothing while the tool still aligns.
  double way() const {
    if (!aligned()) return 0;
    return std::min(parameters_.track, parameters_.distance * 10 - gone_);
  }

  void see(const Edge& edge) {
    // edge.at is of the one point; the profile's end is known from it well enough for the clock.
    clock_.saw(edge.at + sensing::scan_time / 2 + interpreting);
    const Eigen::Isometry3d pose = pose_at(edge.at);
    const double slope = edge.slope * degree;
    const Eigen::Vector3d point = pose * Eigen::Vector3d(0, edge.y, edge.z);
    watch(edge);
    strays_ = strays(point, pose.linear().col(0)) ? strays_ + 1 : 0;
    if (strays_ > 0) return;
    map_.add(point, pose.linear() * Eigen::Vector3d(0, std::cos(slope), std::sin(slope)));
    if (parameters_.literal) law_.see(edge.y, edge.z, edge.slope, gone_);
  }

  // How far off the tool is, as a profile shows it. A tool that aligns must come nearer; one that goes along
  // the edge must stay near.
  void watch(const Edge& edge) {
    off_ = std::hypot(edge.y, edge.z - parameters_.standoff * 10);
    const bool was_aligned = aligned();
    aligned_ = aligned_ || (off_ <= beside_edge && std::abs(edge.slope) <= square_to_it);
    const double most = parameters_.literal ? strays_from_literal : strays_from;
    far_off_ = was_aligned && off_ > most ? far_off_ + 1 : 0;
    ++since_nearer_;
    const double missing = off_ + std::abs(edge.slope);
    if (was_aligned || missing < least_off_ - nearer) since_nearer_ = 0, least_off_ = missing;
  }

  // Whether a point belongs to another edge. Where an edge ends, the range finder sees others beside it. The
  // thesis's law knows no map, and may be several mm off its edge.
  bool strays(const Eigen::Vector3d& point, const Eigen::Vector3d& heading) const {
    if (parameters_.literal) return false;
    const auto expected = map_.at(point, heading);
    return expected && (expected->point - point).norm() > strays_from;
  }

  // What is missing at the edge between where all motions so far lead and where the edge is expected there.
  EdgeCorrection towards_edge() const {
    EdgeCorrection missing;
    const Eigen::Vector3d heading = goal_.linear().col(0);
    const Eigen::Vector3d before = goal_ * Eigen::Vector3d(0, 0, parameters_.standoff * 10);
    const auto place = map_.at(before, heading);
    if (!place) return missing;
    Eigen::Matrix3d wanted;
    const Eigen::Vector3d depth = place->along.cross(place->across).normalized();
    wanted << place->along, depth.cross(place->along), depth;
    const Eigen::Vector3d off = goal_.linear().transpose() * (place->point - before);
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(goal_.linear().transpose() * wanted));
    const Eigen::Vector3d about = turn.axis() * turn.angle() / degree;
    missing.y = limited(part * off.y(), parameters_.translation);
    missing.z = limited(part * off.z(), parameters_.translation);
    missing.rx = limited(part * about.x(), most_turn_);
    missing.ry = limited(part * about.y(), most_turn_);
    missing.rz = limited(part * about.z(), most_turn_);
    return missing;
  }

  // As in the thesis (appendix F.2) the tip is at the edge, a standoff away from the range finder, and the
  // tool turns about that. A turn about the range finder would take the tool off the edge: by 1.75 mm for
  // half a degree at 200 mm.
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
  bool aligned_ = false;
  double off_ = 0;                        // mm, as the newest profile shows it
  double least_off_ = 0;                  // mm and deg together, while the tool aligns
  int since_nearer_ = 0;                  // profiles
  int far_off_ = 0;                       // profiles, one after the other
  int aligning_ = 0, most_aligning_ = 0;  // cycles
  double most_turn_ = 0;                  // deg in a cycle
  LiteralLaw law_;
};

}  // namespace

std::unique_ptr<runtime::Skill> follow_edge_skill() {
  auto obeyed = std::make_shared<MotionCount>(0);
  return make_follow_edge(std::make_unique<Method>(obeyed), std::make_unique<EdgeSensor<LS2Activities>>(),
                          std::make_unique<AlterController<MC1Activities>>(Late::hold, obeyed));
}

}  // namespace pal::skills
