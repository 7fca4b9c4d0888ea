// What the cell looks like: its bodies with their shapes, which do not change. Where bodies are comes by the
// channel `poses`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "server/locations.hpp"

namespace pal::server {

/// A frame within another one.
struct ScenePose {
  std::array<double, 3> position{};        // m
  std::array<double, 4> turn{0, 0, 0, 1};  // unit quaternion: x, y, z, w
};

struct SceneBody {
  std::string name;    // may be empty
  bool moves = false;  // it has a row in the channel `poses`, in the order of the bodies
  ScenePose pose;      // in the world; of a body that moves: when the scene was made
};

/// Sizes in m:
/// - a box, an ellipsoid: half lengths;
/// - a cylinder or a capsule: radius, half length along z;
/// - a sphere: radius;
/// - a plane at z = 0: half lengths; 0: without an end;
/// - a mesh: half lengths of its box.
struct SceneShape {
  enum class Kind { plane, sphere, capsule, ellipsoid, cylinder, box, mesh };
  Kind kind = Kind::box;
  std::size_t body = 0;  // into Scene::bodies
  std::array<double, 3> size{};
  ScenePose pose;                  // in its body
  std::array<double, 4> colour{};  // red, green, blue, opacity: 0 to 1
  /// Of a mesh: x, y, z of each corner in the shape's frame, and three corners for each triangle.
  std::vector<float> corners{};
  std::vector<std::uint32_t> triangles{};
};

/// A frame on a body.
struct SceneFrame {
  std::size_t body = 0;  // into Scene::bodies
  ScenePose pose;        // in its body
};

/// The world has z up, and stands on the floor.
struct Scene {
  std::vector<SceneBody> bodies;
  std::vector<SceneShape> shapes;
  SceneFrame tip;     // of the tool
  SceneFrame sensor;  // in which the channel `force` is given
  /// Where a taught location is in the world. For all threads. Null: it is not known.
  std::function<ScenePose(const PoseFigures&)> place{};
  /// The figures of a tool's tip that is there in the world: the inverse of `place`, and null where that is.
  std::function<PoseFigures(const ScenePose&)> figures{};
};

}  // namespace pal::server
