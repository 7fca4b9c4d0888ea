#include "programs/workcell/session/taught_robot.hpp"

#include "sim/controller/motion_controller.hpp"
#include "sim/val/error.hpp"
#include "sim/val/expression.hpp"
#include "sim/val/transformation.hpp"

namespace pal::workcell {

std::map<std::string, server::PoseFigures> CellRobot::taught() const {
  std::map<std::string, server::PoseFigures> result;
  for (const auto& [name, pose] : cell_.val_store().locations) result[name] = sim::val::figures_of(pose);
  return result;
}

void CellRobot::teach_all(const std::vector<server::Location>& locations) {
  auto& known = cell_.val_store().locations;
  std::map<std::string, sim::Pose> fresh;
  for (const server::Location& each : locations) {
    const auto before = known.find(each.name);
    // What the cell was made with stays as exact as it is.
    fresh[each.name] = before != known.end() && !each.changed ? before->second : sim::val::pose_of(each.pose);
  }
  known = std::move(fresh);
}

// As VAL's HERE: by the encoders.
server::Location CellRobot::here() const {
  sim::Workcell& workcell = cell_.workcell();
  const sim::Joints joints = workcell.encoder_joints();
  server::Location result;
  result.pose = sim::val::figures_of(sim::tool_pose(joints, workcell.motion().tool()));
  result.joints = sim::val::val_joints(joints);
  return result;
}

void CellRobot::teach(const std::string& name, const server::PoseFigures& pose) {
  cell_.val_store().locations[name] = sim::val::pose_of(pose);
}

void CellRobot::forget(const std::string& name) {
  cell_.val_store().locations.erase(name);
}

std::string CellRobot::problem_of_name(const std::string& name) const {
  try {
    sim::val::Line line(name);
    const std::string read = line.name();
    line.end();
    // VAL reads all letters as capitals.
    return read == name ? "" : "'" + name + "' would be read as '" + read + "'";
  } catch (const sim::val::Error& error) {
    return "'" + name + "' is no name of a location: " + error.shown();
  }
}

}  // namespace pal::workcell
