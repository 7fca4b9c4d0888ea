#include "sim/workcell.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "sim/arm/joint_sensing.hpp"
#include "sim/controller/gripper_servo.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/controller/trail.hpp"
#include "sim/model/contacts.hpp"
#include "sim/model/mujoco_physics.hpp"
#include "sim/model/names.hpp"

namespace pal::sim {
namespace {

// How long the arm backs off after a fault. If it cannot, its drives let go for as long: what it pressed on
// pushes it away, as far as the friction of its gears allows.
constexpr runtime::Time back_off_time = std::chrono::milliseconds(300);
// rad/s or m/s of any joint and loose thing: slower is standing. What creeps at this speed takes minutes for
// an encoder's count.
constexpr double still_speed = 1e-6;
constexpr runtime::Time rests_after = std::chrono::milliseconds(500);

using FaultListener = std::function<void(const ArmFault&)>;
using SampleListener = std::function<void(const Sample&)>;

Joints start_joints(const Physics& physics, const WorkcellOptions& options) {
  if (options.start) return *options.start;
  Start start = physics.loaded().start;
  start.tool.translation().z() += options.raise * 1e-3;
  const InverseSolution solution =
      inverse_tool(start.tool, flange_to_tip_of(physics.loaded().tool), start.configuration, Joints::Zero());
  if (solution.problem != InverseProblem::none)
    throw SceneError(start.place,
                     "the arm cannot bring the tool to its start as " + to_string(start.configuration),
                     "move the start into the arm's reach, or choose another configuration");
  return solution.q;
}

// The scene's line of what a shape belongs to; 0: it has none.
int line_of(const Physics& physics, int geom) {
  const auto found = physics.loaded().lines.find(thing_of(physics.model(), geom));
  return found == physics.loaded().lines.end() ? 0 : found->second;
}

// " of line 5", or nothing.
std::string of_line(int line) {
  return line == 0 ? "" : " of line " + std::to_string(line);
}

void refuse_overlap(const Physics& physics, const Scene& scene) {
  const auto pair = overlapping_part(physics);
  if (!pair) return;
  const auto [part, other] = *pair;
  const int line = line_of(physics, part);
  throw SceneError(scene.file.string() + (line == 0 ? "" : ":" + std::to_string(line)),
                   words_for(physics.model(), part) + " overlaps " + words_for(physics.model(), other) +
                       of_line(line_of(physics, other)),
                   "move them apart: physics would throw them out of one another");
}

std::string millimetres(double metres) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f mm", metres * 1e3);
  return text.data();
}

}  // namespace

struct Workcell::Parts {
  static MachineOptions machine_of(const WorkcellOptions& options, const Physics& physics) {
    MachineOptions machine = options.machine.value_or(physics.loaded().machine);
    machine.seed = options.machine_seed.value_or(machine.seed);
    return machine;
  }

  Parts(const Scene& scene, const WorkcellOptions& options)
      : physics(scene),
        tool(flange_to_tip_of(physics.loaded().tool)),
        motion(start_joints(physics, options), alter_period, tool),
        trail(tool),
        machine(machine_of(options, physics)),
        sensing(machine),
        keep_log(options.keep_log) {
    if (keep_log) log.reserve(static_cast<std::size_t>(options.log_room / physics_step));
    physics.place(motion.at(runtime::Time::zero()).position);
    if (const auto touching = any_contact_of_arm(physics))
      throw SceneError(
          physics.loaded().start.place,
          "at its start " + contact_words(physics.model(), touching->first, "touches", touching->second) +
              of_line(std::max(line_of(physics, touching->first), line_of(physics, touching->second))),
          "move the start away from it, or choose another configuration");
    refuse_overlap(physics, scene);
    try {
      for (runtime::Time t{}; t < options.settle; t += physics_step) step(runtime::Time::zero());
    } catch (const std::runtime_error& problem) {
      throw SceneError(scene.file.string(), problem.what(),
                       "let fewer things touch one another at the start");
    }
  }

  void step(runtime::Time when) {
    const Joints q = sensing.read(physics.joints());
    if (retreat > runtime::Time::zero()) {
      retreat -= physics_step;
      // In the end the arm stands where it came to, and its integral action pulls at nothing.
      if (retreat > runtime::Time::zero() && trail.leads_back(stopped_at))
        motion.hold(trail.back(stopped_at, 1 - std::chrono::duration<double>(retreat) / back_off_time));
      else
        give_way();
    }
    SetPoint wanted = motion.at(when);
    wanted.position = sensing.nearest(wanted.position);
    if (!fault) trail.note(q, wanted.position);
    const Joints torques =
        servos.torques(wanted, q, physics.joint_speeds(), physics.load(wanted.acceleration));
    sensing.advance(torques);
    physics.step(torques, finger_forces());
  }

  void note_stillness() {
    const mjData& data = physics.data();
    double fastest = 0;
    for (int i = 0; i < physics.model().nv; ++i) fastest = std::max(fastest, std::abs(data.qvel[i]));
    still_for = fastest < still_speed ? still_for + physics_step : runtime::Time::zero();
  }
  bool rests() const {
    return may_rest && still_for >= rests_after && retreat <= runtime::Time::zero() && motion.idle(now);
  }

  std::array<double, 2> finger_forces() {
    if (physics.loaded().tool != ToolKind::gripper) return {};
    const mjData& data = physics.data();
    const auto& [left, right] = physics.index().fingers;
    return gripper.forces({data.qpos[left.position], data.qpos[right.position]},
                          {data.qvel[left.speed], data.qvel[right.speed]});
  }

  double grip_force() const {
    const Grip held = grip(physics);
    return 0.5 * (held.left + held.right);
  }

  double gripper_width() const {
    if (physics.loaded().tool != ToolKind::gripper) return 0;
    const auto& [left, right] = physics.index().fingers;
    return 1e3 * (physics.data().qpos[left.position] + physics.data().qpos[right.position]);
  }

  Wrench wrench() const {
    // MuJoCo gives what the arm does to the tool; the sensor what the tool does to the arm.
    const mjtNum* data = physics.data().sensordata;
    return {-Eigen::Map<const Eigen::Vector3d>(data + physics.index().force),
            -Eigen::Map<const Eigen::Vector3d>(data + physics.index().torque)};
  }

  Sample sample() {
    const Pose tip = physics.site_pose(physics.index().tip);
    const Joints wanted = motion.at(now).position;
    const Pose set_point = tool_pose(wanted, tool);
    return {.time = now - log_zero,
            .joints = physics.joints(),
            .joint_set_point = wanted,
            .tool = tip.translation(),
            .tool_turn = Eigen::Quaterniond(tip.linear()),
            .set_point = set_point.translation(),
            .set_point_turn = Eigen::Quaterniond(set_point.linear()),
            .contact_force = contact_force(physics),
            .grip_force = grip_force(),
            .wrench = wrench(),
            .gripper_width = gripper_width()};
  }

  // What stops the arm, if anything does.
  std::optional<ArmFault> look(const Sample& sample) {
    if (const auto hit = collisions.look(physics)) {
      const auto of_arm = [&](int geom) {
        return physics.index().roles[static_cast<std::size_t>(geom)] != Role::cell;
      };
      return ArmFault{of_arm(hit->first) && of_arm(hit->second) ? ArmFault::Kind::self_collision
                                                                : ArmFault::Kind::collision,
                      contact_words(physics.model(), hit->first, "hit", hit->second), now,
                      place_of(physics, *hit)};
    }
    const double error = (sample.tool - sample.set_point).norm();
    if (error * 1e3 <= greatest_following_error) return std::nullopt;
    const std::string off = "the tool is " + millimetres(error) + " from where it was told to be";
    // Something that was made to touch may be in the arm's way: that comes first, for reasons are cut.
    if (const auto pressed = hardest_contact(physics))
      return ArmFault{
          ArmFault::Kind::following_error,
          contact_words(physics.model(), pressed->first, "presses on", pressed->second) + "; " + off, now,
          place_of(physics, *pressed)};
    Eigen::Index joint = 0;
    (sample.joints - sample.joint_set_point).cwiseAbs().maxCoeff(&joint);
    return ArmFault{ArmFault::Kind::following_error,
                    off + "; the joint farthest off is joint " + std::to_string(joint + 1), now};
  }

  // The set-point is where the encoders show the arm to be: nothing but gears, brakes and friction holds it.
  void give_way() {
    motion.hold(sensing.read(physics.joints()));
    servos.reset();
  }

  void stop_with(ArmFault why) {
    give_way();
    retreat = back_off_time;
    stopped_at = sensing.read(physics.joints());
    fault = std::move(why);
    std::erase_if(listeners, [](const auto& listener) { return listener.expired(); });
    const auto told = listeners;  // a listener may add others
    for (const auto& listener : told)
      if (const auto alive = listener.lock()) (*alive)(*fault);
  }

  void tell(const Sample& sample) {
    std::erase_if(sample_listeners, [](const auto& listener) { return listener.expired(); });
    for (const auto& listener : sample_listeners)
      if (const auto alive = listener.lock()) (*alive)(sample);
  }

  Physics physics;
  Pose tool;  // from the flange to the tip
  MotionController motion;
  Trail trail;
  MachineOptions machine;
  JointSensing sensing;
  JointServos servos;
  GripperServo gripper;
  CollisionWatch collisions;
  std::optional<ArmFault> fault;
  Joints stopped_at = Joints::Zero();
  runtime::Time retreat{};  // how long the arm still backs off, or gives way
  std::vector<std::weak_ptr<FaultListener>> listeners;
  std::vector<std::weak_ptr<SampleListener>> sample_listeners;
  runtime::Time now{};
  bool may_rest = false;
  runtime::Time still_for{};  // nothing has moved
  Sample last;
  bool keep_log;
  runtime::Time log_zero{};
  std::vector<Sample> log;
};

Workcell::Workcell(const Scene& scene, const WorkcellOptions& options)
    : parts_(std::make_unique<Parts>(scene, options)) {}

Workcell::~Workcell() = default;

void Workcell::advance_to(runtime::Time when) {
  while (parts_->now + physics_step <= when) {
    const bool rests = parts_->rests();
    if (!rests) {
      parts_->step(parts_->now);
      parts_->note_stillness();
    }
    parts_->now += physics_step;
    if (!rests) parts_->last = parts_->sample();
    Sample& sample = parts_->last;
    sample.time = parts_->now - parts_->log_zero;
    if (!parts_->keep_log) parts_->log.clear();
    if (sample.time >= runtime::Time::zero()) {
      parts_->log.push_back(sample);
      parts_->tell(sample);
    }
    if (parts_->fault || rests) continue;
    if (auto fault = parts_->look(sample)) parts_->stop_with(std::move(*fault));
  }
}

void Workcell::let_rest(bool allowed) {
  parts_->may_rest = allowed;
}

void Workcell::begin_log(runtime::Time zero) {
  parts_->log.clear();
  parts_->log_zero = zero;
}

runtime::Time Workcell::log_time() const {
  return parts_->now - parts_->log_zero;
}

runtime::Time Workcell::now() const {
  return parts_->now;
}

std::optional<std::string> Workcell::move(const Correction& correction, CorrectionFrame frame,
                                          runtime::Time begin) {
  if (parts_->fault) return "the arm has stopped: " + parts_->fault->text;
  auto refused = parts_->motion.correct(correction, frame, begin);
  if (refused) stop();
  return refused;
}

void Workcell::stop() {
  parts_->still_for = {};
  parts_->motion.stop(parts_->now);
}

bool Workcell::idle() const {
  return parts_->motion.idle(parts_->now);
}

const std::optional<ArmFault>& Workcell::fault() const {
  return parts_->fault;
}

void Workcell::reset_fault() {
  parts_->fault.reset();
  parts_->still_for = {};
  parts_->retreat = runtime::Time::zero();
  parts_->give_way();
  parts_->trail.forget();
  parts_->collisions.forgive(parts_->physics);
}

std::shared_ptr<void> Workcell::on_fault(std::function<void(const ArmFault&)> listener) {
  auto shared = std::make_shared<FaultListener>(std::move(listener));
  parts_->listeners.push_back(shared);
  return shared;
}

std::shared_ptr<void> Workcell::on_sample(std::function<void(const Sample&)> listener) {
  auto shared = std::make_shared<SampleListener>(std::move(listener));
  parts_->sample_listeners.push_back(shared);
  return shared;
}

Joints Workcell::joints() const {
  return parts_->physics.joints();
}

Joints Workcell::encoder_joints() const {
  return parts_->sensing.read(parts_->physics.joints());
}

Pose Workcell::tool() const {
  return parts_->physics.site_pose(parts_->physics.index().tip);
}

Pose Workcell::set_point() const {
  return tool_pose(parts_->motion.at(parts_->now).position, parts_->tool);
}

Wrench Workcell::wrench() const {
  return parts_->wrench();
}

Wrench Workcell::tool_weight() const {
  const Physics& physics = parts_->physics;
  const Pose tip = tool_pose(encoder_joints(), parts_->tool);
  const Eigen::Vector3d down = tip.linear().transpose() * -Eigen::Vector3d::UnitZ();
  const ToolMass mass = physics.tool_mass();
  const Eigen::Vector3d force = mass.weight * (mass.turn * down);
  return {force, mass.centre.cross(force)};
}

MotionController& Workcell::motion() {
  return parts_->motion;
}

const std::vector<Sample>& Workcell::log() const {
  return parts_->log;
}

const std::map<std::string, Pose>& Workcell::locations() const {
  return parts_->physics.loaded().locations;
}

const std::map<std::string, Eigen::Vector3d>& Workcell::fixed_sensors() const {
  return parts_->physics.loaded().sensors;
}

const MachineOptions& Workcell::machine() const {
  return parts_->machine;
}

ToolKind Workcell::tool_kind() const {
  return parts_->physics.loaded().tool;
}

Pose Workcell::flange_to_tip() const {
  return parts_->tool;
}

double Workcell::pad_stiffness() const {
  const int joint = parts_->physics.index().pad_joint;
  return joint < 0 ? 0 : parts_->physics.model().jnt_stiffness[joint];
}

void Workcell::gripper_command(double width, double force) {
  parts_->still_for = {};
  parts_->gripper.command(parts_->gripper_width(), width, force);
}

double Workcell::gripper_width() const {
  return parts_->gripper_width();
}

double Workcell::gripper_force() const {
  return parts_->grip_force();
}

bool Workcell::holds_part() const {
  return grip(parts_->physics).part;
}

std::optional<double> Workcell::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  // The arm's shapes are group 1 (sim/scenes/puma560.xml), and group 3 is what is felt and not seen.
  static constexpr std::array<mjtByte, mjNGROUP> groups{1, 0, 1, 0, 1, 1};
  const Physics& physics = parts_->physics;
  const Pose base = physics.base_pose();
  const Eigen::Vector3d from = base * origin;
  const Eigen::Vector3d along = base.linear() * direction.normalized();
  int met = -1;
  const double distance =
      mj_ray(&physics.model(), &physics.data(), from.data(), along.data(), groups.data(), 1, -1, &met);
  if (met < 0) return std::nullopt;
  return distance;
}

Physics& Workcell::physics() {
  return parts_->physics;
}

}  // namespace pal::sim
