#include "sim/picture/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace pal::sim {
namespace {

constexpr double arm_reach = 1.2;  // m from the base, horizontally: what stands farther away is no workpiece
constexpr double greatest_shape = 1.5;     // m: what is larger is a floor or a wall
constexpr double margin = 0.07;            // of the picture's half
constexpr double opening = 30;             // degrees
constexpr double contact_height = 0.13;    // m: what the close-up shows at least
constexpr double farthest_surface = 0.50;  // m before the tip: what is farther away is not its business yet
constexpr double narrow = 20;              // degrees: the opening of the close-up

std::array<Eigen::Vector3d, 8> corners(const Stage& stage, int geom) {
  const mjModel& model = stage.model();
  const mjtNum* size = model.geom_size + 3 * geom;
  Eigen::Vector3d half;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      half.setConstant(size[0]);
      break;
    case mjGEOM_CAPSULE:
      half = {size[0], size[0], size[1] + size[0]};
      break;
    case mjGEOM_CYLINDER:
      half = {size[0], size[0], size[1]};
      break;
    case mjGEOM_BOX:
    case mjGEOM_ELLIPSOID:
      half = {size[0], size[1], size[2]};
      break;
    default:
      half.setConstant(model.geom_rbound[geom]);
  }
  const Eigen::Map<const Eigen::Vector3d> middle(stage.data().geom_xpos + 3 * geom);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(stage.data().geom_xmat +
                                                                            9 * geom);
  std::array<Eigen::Vector3d, 8> result;
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
    result[i] = middle + turn * half.cwiseProduct(sign);
  }
  return result;
}

bool worth_seeing(const Stage& stage, int geom) {
  const mjModel& model = stage.model();
  if (model.geom_group[geom] > 2 || model.geom_type[geom] == mjGEOM_PLANE) return false;
  if (stage.of_arm(model.geom_bodyid[geom])) return true;
  const mjtNum* position = stage.data().geom_xpos + 3 * geom;
  return model.geom_rbound[geom] < greatest_shape && std::hypot(position[0], position[1]) < arm_reach;
}

/// How many of the points on the tool can be seen from the eye.
int seen(const Stage& stage, const Eigen::Vector3d& eye) {
  int count = 0;
  for (const double above : {0.002, 0.02, 0.05, 0.10}) {
    const Eigen::Vector3d point = stage.tip() + Eigen::Vector3d(0, 0, above);
    const Eigen::Vector3d ray = (point - eye).normalized();
    int hit = -1;
    const mjtNum distance =
        mj_ray(&stage.model(), &stage.data(), eye.data(), ray.data(), nullptr, 1, -1, &hit);
    const bool behind = distance < 0 || distance > (point - eye).norm();
    if (hit < 0 || behind || stage.of_tool(stage.model().geom_bodyid[hit])) ++count;
  }
  return count;
}

/// The first of the directions, best liked first, from which nothing hides the tool; if there is none, the
/// one that shows most of it. Azimuths count from the one in which the arm reaches.
View choose(const Stage& stage, const std::vector<double>& azimuths, const std::vector<double>& elevations,
            double distance) {
  const Eigen::Vector3d tip = stage.tip();
  const double heading = std::atan2(tip.y(), tip.x()) * 180 / mjPI;
  View best;
  int most = -1;
  for (const double elevation : elevations)
    for (const double azimuth : azimuths) {
      const View view{
          .azimuth = heading + azimuth, .elevation = elevation, .distance = distance, .target = tip};
      const int count = seen(stage, view.eye());
      if (count > most) {
        most = count;
        best = view;
      }
    }
  return best;
}

/// The same for a place where parts meet: one of them may not hide it from the eye.
View choose_for_place(const Stage& stage, const Eigen::Vector3d& place, double distance) {
  constexpr double hidden = 0.03;  // m before the place: nearer is one of the parts that meet there
  const double heading = std::atan2(place.y(), place.x()) * 180 / mjPI;
  View best;
  double least = 1e300;
  for (const double elevation : {-10.0, -22.0, -35.0, -50.0, 10.0})
    for (double azimuth = 0; azimuth < 360; azimuth += 15) {
      const View view{
          .azimuth = heading + 135 + azimuth, .elevation = elevation, .distance = distance, .target = place};
      const Eigen::Vector3d ray = (place - view.eye()).normalized();
      const Eigen::Vector3d eye = view.eye();
      int hit = -1;
      const mjtNum met = mj_ray(&stage.model(), &stage.data(), eye.data(), ray.data(), nullptr, 1, -1, &hit);
      const double before = hit < 0 ? 0 : std::max(0.0, distance - met);
      if (before < hidden) return view;
      if (before < least) least = before, best = view;
    }
  return best;
}

double distance_for(double height) {
  return height / 2 / std::tan(narrow / 2 * mjPI / 180);
}

/// From the tip to the surface that the tool points at; 0 if there is none near.
double gap_before(const Stage& stage) {
  const std::array<mjtByte, mjNGROUP> surroundings{1, 0, 0, 0, 0, 0};  // the arm is in another group
  const Eigen::Vector3d tip = stage.tip(), ray = stage.pointing();
  int hit = -1;
  const mjtNum gap =
      mj_ray(&stage.model(), &stage.data(), tip.data(), ray.data(), surroundings.data(), 1, -1, &hit);
  return hit < 0 || gap > farthest_surface ? 0 : gap;
}

// From the front, half to the side, first that of the shoulder, on which a righty's upper arm is.
const std::vector<double> azimuths{135, 120, 150, 105, 90, -135, -120, -150, -105, -90};

Framing choose_framing(const Stage& stage, double aspect) {
  const View view = choose(stage, azimuths, {-16, -26, -38}, 3);
  return {view.azimuth, view.elevation, opening, aspect, margin};
}

}  // namespace

WorkcellCamera::WorkcellCamera(const Stage& stage, double aspect, const std::string& camera)
    : fixed_(mj_name2id(&stage.model(), mjOBJ_CAMERA, camera.c_str())),
      framing_(choose_framing(stage, aspect)) {}

void WorkcellCamera::include_all(const Stage& stage) {
  for (int geom = 0; geom < stage.model().ngeom; ++geom)
    if (worth_seeing(stage, geom))
      for (const Eigen::Vector3d& corner : corners(stage, geom)) framing_.include(corner);
}

View WorkcellCamera::view(const Stage& stage, double calm) {
  include_all(stage);
  const View best = framing_.view();
  if (!begun_) shown_ = best;
  begun_ = true;
  // All views of a framing look the same way: between two of them it is enough to shift the eye.
  shown_.target = calm * shown_.target + (1 - calm) * best.target;
  shown_.fixed = fixed_;
  return shown_;
}

ContactCamera::ContactCamera(const Stage& stage)
    : direction_(choose(stage, azimuths, {-10, -22, -35, -50}, distance_for(contact_height))) {
  direction_.opening = narrow;
}

View ContactCamera::view_of_place(const Stage& stage, const Eigen::Vector3d& place) {
  constexpr double around = 0.36;  // m
  if (!place_ || (*place_ - place).norm() > 0.01) {
    place_ = place;
    place_view_ = choose_for_place(stage, place, distance_for(around));
    place_view_.opening = narrow;
  }
  return place_view_;
}

View ContactCamera::view(const Stage& stage, double calm) {
  const double gap = gap_before(stage);
  shown_gap_ = shown_gap_ < 0 ? gap : calm * shown_gap_ + (1 - calm) * gap;
  View view = direction_;
  view.distance = distance_for(contact_height + 1.3 * shown_gap_);
  // There is twice as much above the tip as there is below the surface.
  view.target = stage.tip() + shown_gap_ / 2 * stage.pointing() + Eigen::Vector3d(0, 0, contact_height / 6);
  return view;
}

}  // namespace pal::sim
