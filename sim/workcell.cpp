#include "sim/workcell.hpp"

#include <array>

#include "sim/controller/motion_controller.hpp"
#include "sim/model/private/load.hpp"
#include "sim/model/private/physics.hpp"

namespace pal::sim {
namespace {

Joints start_joints(const Scene& scene, const Physics& physics, double raise) {
  Start start = read_start(physics.model(), scene);
  start.tool.translation().z() += raise * 1e-3;
  const InverseSolution solution = inverse_tool(start.tool, start.configuration, Joints::Zero());
  if (solution.problem != InverseProblem::none)
    throw SceneError(scene.file.string(),
                     "the arm cannot bring the tool to its start as " + to_string(start.configuration),
                     "move the start into the arm's reach, or choose another configuration");
  return solution.q;
}

}  // namespace

struct Workcell::Parts {
  Parts(const Scene& scene, const WorkcellOptions& options)
      : physics(scene), motion(start_joints(scene, physics, options.raise), alter_period) {
    log.reserve(static_cast<std::size_t>(options.log_room / physics_step));
    physics.place(motion.at(runtime::Time::zero()).position);
    if (contact_force() > 0)
      throw SceneError(scene.file.string(), "the tool touches something at its start", "raise the start");
    for (runtime::Time t{}; t < options.settle; t += physics_step) step(runtime::Time::zero());
  }

  void step(runtime::Time when) {
    const SetPoint wanted = motion.at(when);
    physics.step(
        servos.torques(wanted, physics.joints(), physics.joint_speeds(), physics.load(wanted.acceleration)));
  }

  // Over all contacts of the tip.
  double contact_force() const {
    double sum = 0;
    const mjData& data = physics.data();
    for (int i = 0; i < data.ncon; ++i) {
      const mjContact& contact = data.contact[i];
      if (contact.geom1 != physics.index().tip_geom && contact.geom2 != physics.index().tip_geom) continue;
      std::array<mjtNum, 6> force{};
      mj_contactForce(&physics.model(), &data, i, force.data());
      sum += force[0];
    }
    return sum;
  }

  Wrench wrench() const {
    // MuJoCo gives what the arm does to the tool; the sensor what the tool does to the arm.
    const mjtNum* data = physics.data().sensordata;
    return {-Eigen::Map<const Eigen::Vector3d>(data + physics.index().force),
            -Eigen::Map<const Eigen::Vector3d>(data + physics.index().torque)};
  }

  Sample sample() {
    const Pose tool = physics.site_pose(physics.index().tip);
    const Joints wanted = motion.at(now).position;
    const Pose set_point = tool_pose(wanted);
    return {.time = now,
            .joints = physics.joints(),
            .joint_set_point = wanted,
            .tool = tool.translation(),
            .tool_turn = Eigen::Quaterniond(tool.linear()),
            .set_point = set_point.translation(),
            .set_point_turn = Eigen::Quaterniond(set_point.linear()),
            .contact_force = contact_force(),
            .wrench = wrench()};
  }

  Physics physics;
  MotionController motion;
  JointServos servos;
  runtime::Time now{};
  std::vector<Sample> log;
};

Workcell::Workcell(const Scene& scene, const WorkcellOptions& options)
    : parts_(std::make_unique<Parts>(scene, options)) {}

Workcell::~Workcell() = default;

void Workcell::advance_to(runtime::Time when) {
  while (parts_->now + physics_step <= when) {
    parts_->step(parts_->now);
    parts_->now += physics_step;
    parts_->log.push_back(parts_->sample());
  }
}

runtime::Time Workcell::now() const {
  return parts_->now;
}

std::optional<std::string> Workcell::move(const Correction& correction, CorrectionFrame frame,
                                          runtime::Time begin) {
  auto refused = parts_->motion.correct(correction, frame, begin);
  if (refused) stop();
  return refused;
}

void Workcell::stop() {
  parts_->motion.stop(parts_->now);
}

bool Workcell::idle() const {
  return parts_->motion.idle(parts_->now);
}

Joints Workcell::joints() const {
  return parts_->physics.joints();
}

Pose Workcell::tool() const {
  return parts_->physics.site_pose(parts_->physics.index().tip);
}

Pose Workcell::set_point() const {
  return tool_pose(parts_->motion.at(parts_->now).position);
}

Wrench Workcell::wrench() const {
  return parts_->wrench();
}

MotionController& Workcell::motion() {
  return parts_->motion;
}

const std::vector<Sample>& Workcell::log() const {
  return parts_->log;
}

double Workcell::pad_stiffness() const {
  return parts_->physics.model().jnt_stiffness[parts_->physics.index().pad_joint];
}

Physics& Workcell::physics() {
  return parts_->physics;
}

}  // namespace pal::sim
