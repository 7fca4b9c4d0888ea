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

void put_mesh(const mjModel& model, int mesh, BodyShape& shape) {
  const float* corners = model.mesh_vert + 3 * static_cast<std::ptrdiff_t>(model.mesh_vertadr[mesh]);
  shape.corners.assign(corners, corners + 3 * static_cast<std::ptrdiff_t>(model.mesh_vertnum[mesh]));
  const int* faces = model.mesh_face + 3 * static_cast<std::ptrdiff_t>(model.mesh_faceadr[mesh]);
  shape.triangles.assign(faces, faces + 3 * static_cast<std::ptrdiff_t>(model.mesh_facenum[mesh]));
}

/// Rows or columns of a surface that are shown: at most so many, its two edges among them.
std::vector<int> shown_lines(int count) {
  constexpr int most = 64;
  std::vector<int> result;
  const int shown = std::min(count, most);
  for (int i = 0; i < shown; ++i) result.push_back(shown == 1 ? 0 : i * (count - 1) / (shown - 1));
  return result;
}

void put_heights(const mjModel& model, int field, BodyShape& shape) {
  const int rows = model.hfield_nrow[field], columns = model.hfield_ncol[field];
  const mjtNum* size = model.hfield_size + 4 * static_cast<std::ptrdiff_t>(field);
  const float* heights = model.hfield_data + model.hfield_adr[field];
  const auto place = [](double half, int at, int count) {
    return static_cast<float>(half * (2.0 * at / std::max(count - 1, 1) - 1));
  };
  const std::vector<int> down = shown_lines(rows), across = shown_lines(columns);
  for (const int row : down)
    for (const int column : across) {
      shape.corners.push_back(place(size[0], column, columns));
      shape.corners.push_back(place(size[1], row, rows));
      shape.corners.push_back(static_cast<float>(size[2]) *
                              heights[static_cast<std::ptrdiff_t>(row) * columns + column]);
    }
  const auto width = static_cast<std::uint32_t>(across.size());
  for (std::uint32_t row = 0; row + 1 < down.size(); ++row)
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      const std::uint32_t at = row * width + column;
      for (const std::uint32_t corner : {at, at + 1, at + width, at + 1, at + width + 1, at + width})
        shape.triangles.push_back(corner);
    }
}

BodyFrame frame_of(const mjModel& model, int site) {
  return {static_cast<std::size_t>(model.site_bodyid[site]), copied<3>(model.site_pos + 3 * site),
          copied<4>(model.site_quat + 4 * site)};
}

/// Whether a joint, or a hand of the program, is between the body and the world.
bool can_move(const mjModel& model, int body) {
  const int root = model.body_weldid[body];
  return root != 0 || model.body_mocapid[model.body_rootid[body]] >= 0;
}

}  // namespace

SceneGeometry scene_geometry(Workcell& workcell) {
  constexpr int hidden_group = 3;  // as in pictures
  const mjModel& model = workcell.physics().model();
  SceneGeometry scene;
  for (int body = 0; body < model.nbody; ++body) {
    scene.bodies.emplace_back(model.names + model.name_bodyadr[body]);
    scene.moves.push_back(can_move(model, body));
  }
  const ModelIndex& index = workcell.physics().index();
  scene.tip = frame_of(model, index.tip);
  scene.sensor = frame_of(model, index.sensor);
  scene.base.body = static_cast<std::size_t>(index.base);
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
    if (model.geom_type[geom] == mjGEOM_MESH) put_mesh(model, model.geom_dataid[geom], scene.shapes.back());
    if (model.geom_type[geom] == mjGEOM_HFIELD)
      put_heights(model, model.geom_dataid[geom], scene.shapes.back());
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

std::vector<ContactPoint> contact_points(Workcell& workcell) {
  constexpr double least = 2;  // N
  const Physics& physics = workcell.physics();
  const mjData& data = physics.data();
  std::vector<ContactPoint> points;
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    const auto of_arm = [&](int geom) {
      return physics.index().roles[static_cast<std::size_t>(geom)] != Role::cell;
    };
    std::array<mjtNum, 6> force{};
    mj_contactForce(&physics.model(), &data, i, force.data());
    const bool first = of_arm(contact.geom1), second = of_arm(contact.geom2);
    if (!first && !second && force[0] < least) continue;
    // The frame's rows are the normal, from the first to the second, and two tangents.
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
    Eigen::Vector3d on_second = frame.transpose() * Eigen::Map<const Eigen::Vector3d>(force.data());
    if (first && !second) on_second = -on_second;
    points.push_back({copied<3>(contact.pos), copied<3>(on_second.data())});
  }
  return points;
}

}  // namespace pal::sim
