#include "sim/model/names.hpp"

#include <array>
#include <cctype>
#include <cstring>
#include <string_view>

namespace pal::sim {
namespace {

constexpr std::array<const char*, joint_count> joint_names{"joint1", "joint2", "joint3",
                                                           "joint4", "joint5", "joint6"};

// Bits of contype and conaffinity: 1 and 2 are the arm's and the cell's (sim/scenes/puma560.xml).
constexpr int own_reach = 4;  // from the elbow on, against base, shoulder and upper arm
constexpr int own_tool = 8;   // tools, against the forearm

struct PartWords {
  std::string_view body;
  std::string_view words;
  int contype;      // more than the model's own
  int conaffinity;  // more than the model's own
};

constexpr std::array<PartWords, 13> arm_parts{
    {{"base", "the robot's base", 0, own_reach},
     {"link1", "the shoulder", 0, own_reach},
     {"link2", "the upper arm", 0, own_reach},
     {"link3", "the forearm", own_reach, own_tool},
     {"link4", "the wrist", own_reach, 0},
     {"link5", "the wrist", own_reach, 0},
     {"link6", "the flange", own_reach, 0},
     {"sensor", "the force-torque sensor", own_reach, 0},
     {"tool", "the tool", own_reach | own_tool, 0},
     {"pad", "the tool's tip", own_reach | own_tool, 0},
     {"finger left", "the gripper's left finger", own_reach | own_tool, 0},
     {"finger right", "the gripper's right finger", own_reach | own_tool, 0},
     {"range finder", "the range finder", own_reach | own_tool, 0}}};

const char* name_of(const mjModel& model, mjtObj kind, int id) {
  const char* name = mj_id2name(&model, kind, id);
  return name == nullptr ? "" : name;
}

const PartWords* arm_part(const mjModel& model, int geom) {
  const std::string_view body = name_of(model, mjOBJ_BODY, model.geom_bodyid[geom]);
  for (const PartWords& part : arm_parts)
    if (part.body == body) return &part;
  return nullptr;
}

int require(const mjModel& model, const Scene& scene, mjtObj kind, const char* kind_name, const char* name) {
  const int id = mj_name2id(&model, kind, name);
  if (id < 0)
    throw SceneError(scene.file.string(), std::string("the scene has no ") + kind_name + " '" + name + "'",
                     "include puma560.xml, which has it");
  return id;
}

FingerIndex find_finger(const mjModel& model, const Scene& scene, const char* name, const char* pad) {
  const int joint = require(model, scene, mjOBJ_JOINT, "joint", name);
  return {model.jnt_qposadr[joint], model.jnt_dofadr[joint],
          require(model, scene, mjOBJ_ACTUATOR, "drive", name),
          require(model, scene, mjOBJ_GEOM, "geom", pad)};
}

// The pad touches with all of its rubber, the gripper with its fingers.
bool made_to_touch(std::string_view body) {
  return body == "pad" || body == "finger left" || body == "finger right";
}

}  // namespace

ModelIndex find_names(const mjModel& model, ToolKind tool, const Scene& scene) {
  ModelIndex index;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const int joint = require(model, scene, mjOBJ_JOINT, "joint", joint_names[i]);
    index.position[i] = model.jnt_qposadr[joint];
    index.speed[i] = model.jnt_dofadr[joint];
    index.drive[i] = require(model, scene, mjOBJ_ACTUATOR, "drive", joint_names[i]);
  }
  index.force = model.sensor_adr[require(model, scene, mjOBJ_SENSOR, "sensor", "force")];
  index.torque = model.sensor_adr[require(model, scene, mjOBJ_SENSOR, "sensor", "torque")];
  index.base = require(model, scene, mjOBJ_BODY, "body", "base");
  index.wrist = require(model, scene, mjOBJ_SITE, "site", "wrist");
  index.tip = require(model, scene, mjOBJ_SITE, "site", "tip");
  index.sensor = require(model, scene, mjOBJ_SITE, "site", "sensor");
  if (tool == ToolKind::pad) index.pad_joint = require(model, scene, mjOBJ_JOINT, "joint", "pad");
  if (tool == ToolKind::gripper)
    index.fingers = {find_finger(model, scene, "finger left", "pad left"),
                     find_finger(model, scene, "finger right", "pad right")};
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const PartWords* part = arm_part(model, geom);
    index.roles.push_back(part == nullptr ? Role::cell : made_to_touch(part->body) ? Role::touch : Role::arm);
  }
  return index;
}

void let_arm_meet_itself(mjModel& model, const ModelIndex& index) {
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (index.roles[static_cast<std::size_t>(geom)] == Role::cell) continue;
    const PartWords* part = arm_part(model, geom);
    model.geom_contype[geom] |= part->contype;
    model.geom_conaffinity[geom] |= part->conaffinity;
  }
}

std::string thing_of(const mjModel& model, int geom) {
  std::string name = name_of(model, mjOBJ_GEOM, geom);
  // A scene's things are bodies with a name; their shapes have none.
  for (int body = model.geom_bodyid[geom]; name.empty() && body > 0; body = model.body_parentid[body])
    name = name_of(model, mjOBJ_BODY, body);
  return name;
}

std::string words_for(const mjModel& model, int geom) {
  if (const PartWords* part = arm_part(model, geom)) {
    if (part->body != "tool") return std::string(part->words);
    if (mj_name2id(&model, mjOBJ_BODY, "finger left") >= 0) return "the gripper";
    if (mj_name2id(&model, mjOBJ_BODY, "range finder") >= 0) return "the range finder's bracket";
    return std::string(part->words);
  }
  const std::string name = thing_of(model, geom);
  if (name.empty()) return "something that has no name in the scene";
  const bool numbered = std::isdigit(static_cast<unsigned char>(name.back())) != 0;
  return numbered ? name : "the " + name;
}

std::string contact_words(const mjModel& model, int geom, std::string_view verb, int other) {
  // What is farther out on the arm is said to have hit the rest; arm_parts is in that order.
  const PartWords* const one = arm_part(model, geom);
  const PartWords* const two = arm_part(model, other);
  if (one == nullptr || (two != nullptr && two > one)) std::swap(geom, other);
  return words_for(model, geom) + " " + std::string(verb) + " " + words_for(model, other);
}

}  // namespace pal::sim
