#include "sim/picture/body_pose.hpp"

#include <algorithm>

#include "sim/model/mujoco_physics.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {
namespace {

ShapeKind kind_of(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return ShapeKind::plane;
    case mjGEOM_SPHERE:
      return ShapeKind::sphere;
    case mjGEOM_CAPSULE:
      return ShapeKind::capsule;
    case mjGEOM_ELLIPSOID:
      return ShapeKind::ellipsoid;
    case mjGEOM_CYLINDER:
      return ShapeKind::cylinder;
    case mjGEOM_BOX:
      return ShapeKind::box;
    default:
      return ShapeKind::mesh;
  }
}

template <std::size_t count, class From>
std::array<float, count> copied(const From* from) {
  std::array<float, count> to{};
  std::transform(from, from + count, to.begin(), [](auto value) { return static_cast<float>(value); });
  return to;
}

}  // namespace

SceneGeometry scene_geometry(Workcell& workcell) {
  constexpr int hidden_group = 3;  // as in pictures
  const mjModel& model = workcell.physics().model();
  SceneGeometry scene;
  for (int body = 0; body < model.nbody; ++body)
    scene.bodies.emplace_back(model.names + model.name_bodyadr[body]);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_group[geom] >= hidden_group) continue;
    const int material = model.geom_matid[geom];
    const float* colour = material >= 0 ? model.mat_rgba + 4 * material : model.geom_rgba + 4 * geom;
    scene.shapes.push_back({.kind = kind_of(model.geom_type[geom]),
                            .body = static_cast<std::size_t>(model.geom_bodyid[geom]),
                            .size = copied<3>(model.geom_size + 3 * geom),
                            .position = copied<3>(model.geom_pos + 3 * geom),
                            .turn = copied<4>(model.geom_quat + 4 * geom),
                            .colour = copied<4>(colour)});
  }
  return scene;
}

std::vector<BodyPose> body_poses(Workcell& workcell) {
  const mjData& data = workcell.physics().data();
  std::vector<BodyPose> poses;
  for (int body = 1; body < workcell.physics().model().nbody; ++body)
    poses.push_back({copied<3>(data.xpos + 3 * body), copied<4>(data.xquat + 4 * body)});
  return poses;
}

}  // namespace pal::sim
