#include "programs/workcell/session/live_scene.hpp"

#include <string>
#include <utility>

#include "sim/picture/body_pose.hpp"
#include "sim/val/transformation.hpp"

namespace pal::workcell {
namespace {

constexpr const char *poses = "poses", *contact_points = "contact-points";
constexpr runtime::Time watched_period = std::chrono::milliseconds(34);
constexpr runtime::Time other_period = std::chrono::seconds(1);
// A cell that is quicker than the wall wakes the server no more often.
constexpr std::chrono::milliseconds wall_period(30);

template <class Place, class Turn>
server::ScenePose pose_of(const Place& place, const Turn& turn) {
  // w x y z there, x y z w here.
  return {{place[0], place[1], place[2]}, {turn[1], turn[2], turn[3], turn[0]}};
}

server::SceneFrame frame_of(const sim::BodyFrame& frame) {
  return {frame.body, pose_of(frame.position, frame.turn)};
}

server::SceneShape shape_of(const sim::BodyShape& shape) {
  // The two lists have one order.
  static_assert(static_cast<int>(sim::ShapeKind::mesh) == static_cast<int>(server::SceneShape::Kind::mesh));
  server::SceneShape result;
  result.kind = static_cast<server::SceneShape::Kind>(shape.kind);
  result.body = shape.body;
  for (std::size_t i = 0; i < shape.size.size(); ++i) result.size[i] = shape.size[i];
  result.pose = pose_of(shape.position, shape.turn);
  for (std::size_t i = 0; i < shape.colour.size(); ++i) result.colour[i] = shape.colour[i];
  result.corners = shape.corners;
  result.triangles = shape.triangles;
  return result;
}

}  // namespace

server::Scene scene_of(sim::Workcell& workcell) {
  const sim::SceneGeometry geometry = sim::scene_geometry(workcell);
  const std::vector<sim::BodyPose> now = sim::body_poses(workcell);
  server::Scene scene;
  scene.bodies.push_back({geometry.bodies.front(), false, {}});
  for (std::size_t i = 1; i < geometry.bodies.size(); ++i)
    scene.bodies.push_back(
        {geometry.bodies[i], geometry.moves[i], pose_of(now[i - 1].position, now[i - 1].turn)});
  for (const sim::BodyShape& shape : geometry.shapes) scene.shapes.push_back(shape_of(shape));
  scene.tip = frame_of(geometry.tip);
  scene.sensor = frame_of(geometry.sensor);
  // Frame 0 stands still, so that any thread may use it.
  const sim::BodyPose& at = now.at(geometry.base.body - 1);
  sim::Pose base = sim::Pose::Identity();
  base.translation() = Eigen::Vector3d(at.position[0], at.position[1], at.position[2]);
  base.linear() = Eigen::Quaterniond(at.turn[0], at.turn[1], at.turn[2], at.turn[3]).toRotationMatrix();
  scene.place = [base](const server::PoseFigures& figures) {
    const sim::Pose pose = base * sim::val::pose_of(figures);
    const Eigen::Quaterniond turn(pose.linear());
    return server::ScenePose{{pose.translation().x(), pose.translation().y(), pose.translation().z()},
                             {turn.x(), turn.y(), turn.z(), turn.w()}};
  };
  scene.figures = [base](const server::ScenePose& shown) {
    sim::Pose pose = sim::Pose::Identity();
    pose.translation() = Eigen::Vector3d(shown.position.data());
    pose.linear() = Eigen::Quaterniond(shown.turn.data()).toRotationMatrix();
    return sim::val::shown_figures(base.inverse() * pose);
  };
  return scene;
}

server::Channels scene_channels() {
  using server::Channel;
  const double rate = 1 / std::chrono::duration<double>(watched_period).count();
  return {{poses,
           "where each body is that moves, in the world: a row a body, in the order of the scene; the last "
           "four are a "
           "unit quaternion",
           {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"qx", ""}, {"qy", ""}, {"qz", ""}, {"qw", ""}},
           rate,
           Channel::Form::rows},
          {contact_points,
           "where the arm touches something, and where others press with more than 2 N, in the world: a row "
           "a contact; "
           "the force is what acts on the arm",
           {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"fx", "N"}, {"fy", "N"}, {"fz", "N"}},
           rate,
           Channel::Form::rows}};
}

SceneRecorder::SceneRecorder(sim::Workcell& workcell, server::TelemetrySink& sink)
    : workcell_(workcell),
      sink_(sink),
      moves_(sim::scene_geometry(workcell).moves),
      listener_(workcell.on_sample([this](const sim::Sample&) {
        const runtime::Time now = workcell_.now();
        if (now < due_ && !(sink_.watched() && due_ - now > watched_period)) return;
        record();
        due_ = now + (sink_.watched() ? watched_period : other_period);
        if (std::chrono::steady_clock::now() - handed_on_ >= wall_period) hand_on();
      })) {
  flush();
}

void SceneRecorder::flush() {
  record();
  hand_on();
}

void SceneRecorder::record() {
  auto bodies = std::make_shared<server::Rows>();
  bodies->channel = poses;
  bodies->time = workcell_.now();
  const std::vector<sim::BodyPose> now = sim::body_poses(workcell_);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!moves_[i + 1]) continue;
    const auto& [place, turn] = now[i];
    bodies->numbers.insert(bodies->numbers.end(),
                           {place[0], place[1], place[2], turn[1], turn[2], turn[3], turn[0]});
  }
  auto contacts = std::make_shared<server::Rows>();
  contacts->channel = contact_points;
  contacts->time = bodies->time;
  for (const auto& [place, force] : sim::contact_points(workcell_))
    contacts->numbers.insert(contacts->numbers.end(),
                             {place[0], place[1], place[2], force[0], force[1], force[2]});
  waiting_.push_back(std::move(bodies));
  waiting_.push_back(std::move(contacts));
}

void SceneRecorder::hand_on() {
  handed_on_ = std::chrono::steady_clock::now();
  sink_.show(std::exchange(waiting_, {}));
}

}  // namespace pal::workcell
