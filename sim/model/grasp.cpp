#include "sim/model/grasp.hpp"

#include <Eigen/Geometry>

namespace pal::sim {
namespace {

using Vector = Eigen::Vector3d;
using ConstVector = Eigen::Map<const Vector>;

struct Acceleration {
  Vector turning;
  Vector linear;
};

// Of the point of a body that is at `point`. MuJoCo's spatial vectors (rotation first) are about the centre
// of mass of the body's tree.
Acceleration at_point(const mjModel& model, const mjData& data, const std::vector<mjtNum>& accelerations,
                      int body, const Vector& point) {
  const Vector arm = point - ConstVector(data.subtree_com + 3 * model.body_rootid[body]);
  const mjtNum* acceleration = accelerations.data() + 6 * body;
  const mjtNum* velocity = data.cvel + 6 * body;
  const ConstVector turning(acceleration), spin(velocity);
  const Vector speed = ConstVector(velocity + 3) + spin.cross(arm);
  return {turning, ConstVector(acceleration + 3) + turning.cross(arm) + spin.cross(speed)};
}

bool is_pad(const ModelIndex& index, int geom) {
  return geom == index.fingers[0].pad_geom || geom == index.fingers[1].pad_geom;
}

}  // namespace

void GraspFriction::correct(const mjModel& model, mjData& data, const ModelIndex& index) {
  bool computed = false;
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    if (contact.efc_address < 0 || (!is_pad(index, contact.geom1) && !is_pad(index, contact.geom2))) continue;
    if (!computed) {
      acceleration_.assign(6 * static_cast<std::size_t>(model.nbody), 0);
      for (int body = 1; body < model.nbody; ++body) {
        mjtNum* acceleration = acceleration_.data() + 6 * body;
        mju_copy(acceleration, acceleration_.data() + 6 * model.body_parentid[body], 6);
        for (int k = 0; k < model.body_dofnum[body]; ++k) {
          const int dof = model.body_dofadr[body] + k;
          mju_addToScl(acceleration, data.cdof_dot + 6 * dof, data.qvel[dof], 6);
        }
      }
      computed = true;
    }
    const ConstVector point(contact.pos);
    const Acceleration one = at_point(model, data, acceleration_, model.geom_bodyid[contact.geom1], point);
    const Acceleration other = at_point(model, data, acceleration_, model.geom_bodyid[contact.geom2], point);
    for (int row = 1; row < contact.dim; ++row) {
      const bool along = row < 3;
      const ConstVector axis(contact.frame + 3 * (along ? row : row - 3));
      const Vector missing = along ? other.linear - one.linear : other.turning - one.turning;
      // Positions follow from the speeds at the end of a step. The part must not run ahead of the hand by
      // half a step's worth. So the speeds at which friction comes to rest (damping: KBIP's second) differ by
      // half of what is gained in a step.
      const int constraint = contact.efc_address + row;
      const double damping = data.efc_KBIP[4 * constraint + 1];
      data.efc_aref[constraint] -= (1 - 0.5 * damping * model.opt.timestep) * axis.dot(missing);
    }
  }
}

}  // namespace pal::sim
