// What VAL commands: the arm, the hand and the ALTER port, as it sees them.
#pragma once

#include <optional>
#include <string>

#include "pal/runtime/device.hpp"
#include "sim/controller/planner.hpp"
#include "sim/devices/alter_control.hpp"

namespace pal::sim::val {

/// Poses are those of the tool's tip in frame 0; instants those of the station's clock.
class Arm {
 public:
  virtual ~Arm() = default;

  /// Where the joints are, rad.
  virtual Joints joints() const = 0;
  /// Where they will be when all accepted motions are made.
  virtual Joints goal() const = 0;

  virtual Pose tool() const = 0;
  /// False while anything moves.
  virtual bool set_tool(const Pose& tool) = 0;

  /// Motions begin now, or after those accepted before.
  virtual std::optional<Refusal> move_joints(const Joints& goal, const MotionSpeed& speed) = 0;
  virtual std::optional<Refusal> move_to(const Pose& goal, Configuration configuration,
                                         const MotionSpeed& speed) = 0;
  virtual std::optional<Refusal> move_straight(const Pose& goal, const MotionSpeed& speed) = 0;
  /// Slows down to a stand; the rest is dropped.
  virtual void stop() = 0;
  /// Set-points stand still, and the arm has come to where they are or has had its time for it.
  virtual bool at_rest() const = 0;
  /// When at_rest() is worth asking again.
  virtual runtime::Time look_again() const = 0;

  /// Why the arm does not move until clear_fault(); empty: it does.
  virtual std::string fault() const = 0;
  /// Empty: cleared. Otherwise why it cannot be.
  virtual std::string clear_fault() = 0;
};

/// The gripper.
class Hand {
 public:
  virtual ~Hand() = default;
  virtual void open() = 0;
  virtual void close() = 0;
  /// The fingers have come to rest, at their end or on a part.
  virtual bool at_rest() const = 0;
};

using sim::AlterControl;
using sim::AlterMode;

}  // namespace pal::sim::val
