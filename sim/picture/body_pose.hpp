// The workcell for a view that draws it itself: its shapes once, and a list of poses for each frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pal::sim {

class Workcell;

enum class ShapeKind { plane, sphere, capsule, ellipsoid, cylinder, box, mesh };

/// A shape on a body. Sizes in metres, as MuJoCo counts them:
/// - a box, or a mesh by its box: half lengths;
/// - a cylinder or capsule: radius and half length (along z);
/// - a sphere: radius;
/// - a plane: half lengths, 0 without an end.
struct BodyShape {
  ShapeKind kind = ShapeKind::box;
  std::size_t body = 0;  // into SceneGeometry::bodies
  std::array<float, 3> size{};
  std::array<float, 3> position{};        // in the body's frame, m
  std::array<float, 4> turn{1, 0, 0, 0};  // w x y z
  std::array<float, 4> colour{};          // red, green, blue, opacity, 0 to 1
  /// Of a mesh: x, y, z of each corner in the shape's frame, m, and three corners for each triangle. A
  /// surface of heights is a mesh, too; of a fine one some corners are left out.
  std::vector<float> corners{};
  std::vector<std::uint32_t> triangles{};
};

/// A frame on a body, as of the last step.
struct BodyFrame {
  std::size_t body = 0;                   // into SceneGeometry::bodies
  std::array<float, 3> position{};        // in the body's frame, m
  std::array<float, 4> turn{1, 0, 0, 0};  // w x y z
};

/// What a scene consists of: some 5 kB without meshes. It does not change during a run.
struct SceneGeometry {
  std::vector<std::string> bodies;  // the first is the world, which does not move; empty: nameless
  std::vector<BodyShape> shapes;    // only those that pictures show
  std::vector<bool> moves;          // whether the body can
  BodyFrame tip;                    // of the tool
  BodyFrame sensor;                 // of force and torque
  BodyFrame base;                   // frame 0
};

/// Where a body is, in the world's frame (on the floor, below frame 0): 28 bytes.
struct BodyPose {
  std::array<float, 3> position{};        // m
  std::array<float, 4> turn{1, 0, 0, 0};  // w x y z
};

/// Where something presses, in the world's frame.
struct ContactPoint {
  std::array<float, 3> position{};  // m
  std::array<float, 3> force{};     // N: on the arm, else on the second of the two
};

SceneGeometry scene_geometry(Workcell& workcell);

/// As of the last step: contacts of the arm and of its tool, and those of others that press with more than 2
/// N.
std::vector<ContactPoint> contact_points(Workcell& workcell);

/// As of the last step, in the order of SceneGeometry::bodies without the world. 28 bytes each: 364 in the
/// scene touch.
std::vector<BodyPose> body_poses(Workcell& workcell);

}  // namespace pal::sim
