// The robot, its controller and what it touches, in physics that advances in fixed steps of 1 ms: the pose of
// the tool, the force and torque that its sensor meets, distances, contacts.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/device.hpp"
#include "runtime/drivers/alter/protocol.hpp"
#include "sim/arm/arm_fault.hpp"
#include "sim/arm/kinematics.hpp"
#include "sim/arm/machine.hpp"
#include "sim/arm/tool.hpp"
#include "sim/controller/correction.hpp"
#include "sim/scene.hpp"

namespace pal::sim {

class MotionController;
class Physics;

inline constexpr runtime::Time physics_step = std::chrono::milliseconds(1);
inline constexpr runtime::Time alter_period = runtime::drivers::alter::period;

/// Forces in N and torques in N*m in the frame of the force-torque sensor, whose z points out of the tool.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
};

/// One line of the log, written after each step; `time` counts from where the log begins. Poses are those of
/// the tool's tip in frame 0, in metres.
struct Sample {
  runtime::Time time{};
  Joints joints = Joints::Zero();           // where the joints are, rad
  Joints joint_set_point = Joints::Zero();  // where they have been told to be, rad
  Eigen::Vector3d tool = Eigen::Vector3d::Zero();
  Eigen::Quaterniond tool_turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d set_point = Eigen::Vector3d::Zero();
  Eigen::Quaterniond set_point_turn = Eigen::Quaterniond::Identity();
  double contact_force = 0;  // sum of the normal forces on what the tool is meant to touch with, N; no grip
  double grip_force = 0;     // with which each finger presses on what is between them, N; 0 without a gripper
  Wrench wrench;             // as Workcell::wrench()
  double gripper_width = 0;  // between the fingers, mm; 0 without a gripper
};

struct WorkcellOptions {
  /// Raises the tool's start by this much along the vertical, mm.
  double raise = 0;
  /// Where the joints start, rad; not given: as the scene says.
  std::optional<Joints> start = std::nullopt;
  /// Pause after loading, in which the servos take up the load, before time 0.
  runtime::Time settle = std::chrono::milliseconds(300);
  /// How long a run the log has room for without allocating.
  runtime::Time log_room = std::chrono::seconds(60);
  /// The machine's imperfections; as the scene says if not given.
  std::optional<MachineOptions> machine = std::nullopt;
  /// Another machine of the same kind: its seed in place of the one above.
  std::optional<std::uint64_t> machine_seed = std::nullopt;
  /// False: the log holds the last sample only, for stations that run for long.
  bool keep_log = true;
};

class Workcell final : public runtime::World {
 public:
  /// Loads the scene, places the arm, lets it settle. Throws SceneError.
  explicit Workcell(const Scene& scene, const WorkcellOptions& options = {});
  ~Workcell() override;
  Workcell(const Workcell&) = delete;
  Workcell& operator=(const Workcell&) = delete;

  /// Steps until the last whole millisecond at or before `when`.
  void advance_to(runtime::Time when) override;
  runtime::Time now() const;
  /// Allowed: time passes without physics while nothing in the cell has moved for half a second, until
  /// something is told to move. Samples come as before. Not allowed, as at first: each step is physics, to
  /// the bit. For a cell that waits for clients.
  void let_rest(bool allowed);

  /// Gives the controller a relative motion to be made evenly within one period from `begin` on, after all
  /// those given before. A motion that the arm cannot make is refused: the answer says why, and the arm
  /// stops.
  std::optional<std::string> move(const Correction& correction, CorrectionFrame frame, runtime::Time begin);
  /// Drops what has not been moved yet: a planned motion slows down, corrections end at once.
  void stop();
  /// The owner of the set-point, for those who plan motions. What it is told at `now()` is moved from the
  /// next step on.
  MotionController& motion();
  /// No motion is left to make.
  bool idle() const;

  /// Why the arm stopped by itself, until reset_fault(). It backs off within 0.3 s, up to 15 mm, stands, and
  /// refuses to move.
  const std::optional<ArmFault>& fault() const;
  /// The arm takes motions again, from where it stands. What it touches then is forgiven until they have
  /// parted.
  void reset_fault();
  /// Calls `listener` in the step in which the arm stops, as long as the answer lives.
  [[nodiscard]] std::shared_ptr<void> on_fault(std::function<void(const ArmFault&)> listener);

  Joints joints() const;  // where the joints are
  /// Where the controller believes the joints to be: by the encoders, whose counts and play the joints have.
  Joints encoder_joints() const;
  Pose tool() const;       // the tip, where the arm is
  Pose set_point() const;  // the tip, where the arm has been told to be
  /// What the environment does to the tool, and the tool's weight: pressing gives a negative force along z.
  /// As of the last step.
  Wrench wrench() const;
  /// What the tool's weight alone puts on that sensor where the encoders show the arm to be.
  Wrench tool_weight() const;
  const std::vector<Sample>& log() const;
  /// Calls `listener` with each sample as it comes, as long as the answer lives.
  [[nodiscard]] std::shared_ptr<void> on_sample(std::function<void(const Sample&)> listener);
  /// Forgets the log; its times, and log_time(), count from `zero` on, an instant that is still to come.
  void begin_log(runtime::Time zero);
  runtime::Time log_time() const;

  /// What the scene says that VAL has been taught: poses of the tip. HOME is where the scene starts, unless
  /// it says otherwise.
  const std::map<std::string, Pose>& locations() const;

  /// Distance sensors that are fixed in the cell and look straight down: where they stand in frame 0, m.
  const std::map<std::string, Eigen::Vector3d>& fixed_sensors() const;

  ToolKind tool_kind() const;
  /// As the scene says, unless the options do.
  const MachineOptions& machine() const;
  /// From the flange to the tip.
  Pose flange_to_tip() const;
  /// Newton per metre, of the tool's compliant pad alone; 0 for other tools.
  double pad_stiffness() const;

  /// Moves the fingers to a width (mm, 0 to 80) at 100 mm/s, pressing with at most `force` (N) on what is
  /// between them. Without a gripper nothing happens, as when a valve drives nothing.
  void gripper_command(double width, double force = 30);
  void gripper_open() { gripper_command(gripper_opening); }
  void gripper_close() { gripper_command(0); }
  double gripper_width() const;  // mm between the finger pads; 0 without a gripper
  double gripper_force() const;  // N, mean of the two pads
  /// Both pads press on the same loose part.
  bool holds_part() const;

  /// How far a ray goes from `origin` along `direction` until it meets something that is not the arm. All are
  /// in frame 0, in m. Nothing if it meets nothing. `direction` need not have length 1.
  std::optional<double> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

  /// For pictures; private to the library.
  Physics& physics();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pal::sim
