#include "sim/arm/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace pal::sim {
namespace {

constexpr double a2 = puma_links[1].a;
constexpr double a3 = puma_links[2].a;
constexpr double d3 = puma_links[2].d;
constexpr double d4 = puma_links[3].d;
constexpr double turn = 2.0 * std::numbers::pi;

Pose link_transform(const Link& link, double q) {
  return Eigen::Translation3d(0, 0, 0) * Eigen::AngleAxisd(q, Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(link.a, 0, link.d) * Eigen::AngleAxisd(link.alpha, Eigen::Vector3d::UnitX());
}

Pose along_z(double length) {
  return Pose(Eigen::Translation3d(0, 0, length));
}

// The wrist in the vertical plane of the arm: how far in front of joint 1's axis, how high above the
// shoulder.
struct InPlane {
  double front;
  double height;
};

InPlane in_plane(double q2, double q3) {
  const double q23 = q2 + q3;
  return {a2 * std::cos(q2) + a3 * std::cos(q23) - d4 * std::sin(q23),
          a2 * std::sin(q2) + a3 * std::sin(q23) + d4 * std::cos(q23)};
}

bool elbow_above(double q2, InPlane wrist, bool righty) {
  const double side = std::sin(q2 - std::atan2(wrist.height, wrist.front));
  return righty ? side >= 0 : side < 0;
}

// The full turn of `angle` that is within the limits and nearest to the reference; nothing if none is within.
std::optional<double> within(const JointLimits& limits, double angle, double reference) {
  constexpr double slack = 1e-12;
  std::optional<double> best;
  for (double candidate = std::remainder(angle, turn) - turn; candidate <= limits.upper + slack;
       candidate += turn) {
    if (candidate < limits.lower - slack) continue;
    if (!best || std::abs(candidate - reference) < std::abs(*best - reference)) best = candidate;
  }
  return best;
}

}  // namespace

std::string to_string(Configuration configuration) {
  return std::string(configuration.righty ? "righty" : "lefty") +
         (configuration.above ? " above" : " below") + (configuration.flip ? " flip" : " noflip");
}

std::optional<Configuration> parse_configuration(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::optional<bool> righty, above, flip;
  const auto set = [](std::optional<bool>& slot, bool value) {
    const bool fresh = !slot;
    slot = value;
    return fresh;
  };
  for (std::string word; words >> word;) {
    bool fresh = false;
    if (word == "righty" || word == "lefty") fresh = set(righty, word == "righty");
    if (word == "above" || word == "below") fresh = set(above, word == "above");
    if (word == "flip" || word == "noflip") fresh = set(flip, word == "flip");
    if (!fresh) return std::nullopt;
  }
  if (!righty || !above || !flip) return std::nullopt;
  return Configuration{*righty, *above, *flip};
}

Pose wrist_pose(const Joints& q) {
  Pose pose = Pose::Identity();
  for (std::size_t i = 0; i < joint_count; ++i)
    pose = pose * link_transform(puma_links[i], q[static_cast<Eigen::Index>(i)]);
  return pose;
}

Pose flange_pose(const Joints& q) {
  return wrist_pose(q) * along_z(wrist_to_flange);
}

Pose tool_pose(const Joints& q, const Pose& tool) {
  return flange_pose(q) * tool;
}

Pose tool_pose(const Joints& q) {
  return tool_pose(q, pad_tool());
}

Pose pad_tool() {
  return along_z(flange_to_tip);
}

Configuration configuration_of(const Joints& q) {
  const InPlane wrist = in_plane(q[1], q[2]);
  const bool righty = wrist.front >= 0;
  return {righty, elbow_above(q[1], wrist, righty), q[4] < 0};
}

InverseSolution inverse_wrist(const Pose& wrist, Configuration configuration, const Joints& reference) {
  InverseSolution solution;
  const Eigen::Vector3d p = wrist.translation();

  // Joint 1 turns the plane of the arm, which stands d3 beside its axis, through the wrist.
  const double front_squared = p.x() * p.x() + p.y() * p.y() - d3 * d3;
  if (front_squared < 0) {
    solution.problem = InverseProblem::too_near;
    return solution;
  }
  const double front = (configuration.righty ? 1.0 : -1.0) * std::sqrt(front_squared);
  const double q1 = std::atan2(p.y(), p.x()) - std::atan2(-d3, front);

  // Joints 2 and 3: a triangle of upper arm, forearm (with its small offset a3) and the line to the wrist.
  const double forearm = std::hypot(a3, d4);
  const double cosine = (front_squared + p.z() * p.z() - a2 * a2 - forearm * forearm) / (2 * a2 * forearm);
  if (std::abs(cosine) > 1.0) {
    solution.problem = cosine > 0 ? InverseProblem::too_far : InverseProblem::too_near;
    return solution;
  }
  double q2 = 0, q3 = 0;
  for (const double sign : {1.0, -1.0}) {
    q3 = -std::atan2(d4, a3) + sign * std::acos(cosine);
    const double along = a2 + a3 * std::cos(q3) - d4 * std::sin(q3);
    const double across = a3 * std::sin(q3) + d4 * std::cos(q3);
    q2 = std::atan2(p.z(), front) - std::atan2(across, along);
    if (elbow_above(q2, {front, p.z()}, configuration.righty) == configuration.above) break;
  }

  // The wrist: R = Rz(q4) Ry(-q5) Rz(q6) after the rotation of the first three joints.
  Eigen::Matrix3d arm = Eigen::Matrix3d::Identity();
  const std::array<double, 3> first{q1, q2, q3};
  for (std::size_t i = 0; i < first.size(); ++i) arm = arm * link_transform(puma_links[i], first[i]).linear();
  const Eigen::Matrix3d r = arm.transpose() * wrist.linear();
  const double sine = std::hypot(r(0, 2), r(1, 2));
  const double sign = configuration.flip ? -1.0 : 1.0;
  const double q5 = std::atan2(sign * sine, r(2, 2));
  double q4 = reference[3], q6 = 0;
  if (sine < 1e-9) {
    // Joints 4 and 6 turn about one line: only their sum (or difference, if q5 were 180 degrees) is given.
    q6 = std::atan2(r(1, 0), r(0, 0)) - q4;
  } else {
    q4 = std::atan2(-sign * r(1, 2), -sign * r(0, 2));
    q6 = std::atan2(-sign * r(2, 1), sign * r(2, 0));
  }

  const std::array<double, joint_count> angles{q1, q2, q3, q4, q5, q6};
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const std::optional<double> angle = within(puma_limits[i], angles[i], reference[row]);
    solution.q[row] = angle.value_or(std::remainder(angles[i], turn));
    if (angle || solution.problem == InverseProblem::over_limit) continue;
    solution.problem = InverseProblem::over_limit;
    solution.joint = i;
  }
  return solution;
}

InverseSolution inverse_tool(const Pose& tip, const Pose& tool, Configuration configuration,
                             const Joints& reference) {
  return inverse_wrist(tip * tool.inverse() * along_z(-wrist_to_flange), configuration, reference);
}

InverseSolution next_on_path(const Pose& tip, const Pose& tool, Configuration configuration,
                             const Joints& from) {
  InverseSolution solution = inverse_tool(tip, tool, configuration, from);
  constexpr double half = turn / 2 + 1e-9;
  for (std::size_t i = 0; i < joint_count && solution.problem == InverseProblem::none; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (std::abs(solution.q[row] - from[row]) <= half) continue;
    solution.problem = InverseProblem::over_limit;
    solution.joint = i;
  }
  return solution;
}

InverseSolution inverse_tool(const Pose& tip, Configuration configuration, const Joints& reference) {
  return inverse_tool(tip, pad_tool(), configuration, reference);
}

}  // namespace pal::sim
