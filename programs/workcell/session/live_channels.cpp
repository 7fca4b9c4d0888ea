#include "programs/workcell/session/live_channels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "programs/workcell/session/failure.hpp"
#include "programs/workcell/session/profile_marks.hpp"
#include "sim/val/transformation.hpp"

namespace pal::workcell {
namespace {

using server::Channel;
using server::ChannelField;
using Raw = std::span<const double>;
using Shown = std::span<double>;

// Where each thing begins in a raw record. A pose is a place in m and a turn: x, y, z, w.
constexpr std::size_t wrench_at = 0, tool_at = 6, set_point_at = 13, joints_at = 20, joint_set_points_at = 26,
                      speed_at = 32, contact_at = 33, gripper_at = 34, width = 36;
// In ms of the cell, and of the wall for a cell that is quicker than that.
constexpr server::BlockLength block_length{20, 1020, std::chrono::milliseconds(30)};

constexpr std::array<const char*, 6> pose_names{"x", "y", "z", "O", "A", "T"};

std::vector<ChannelField> pose_fields() {
  std::vector<ChannelField> result;
  for (std::size_t i = 0; i < pose_names.size(); ++i) result.push_back({pose_names[i], i < 3 ? "mm" : "deg"});
  return result;
}

std::vector<ChannelField> joint_fields() {
  std::vector<ChannelField> result;
  for (int i = 1; i <= 6; ++i) result.push_back({"j" + std::to_string(i), "deg"});
  return result;
}

void show_pose(Raw raw, Shown shown) {
  sim::Pose pose = sim::Pose::Identity();
  pose.translation() = Eigen::Vector3d(raw[0], raw[1], raw[2]);
  pose.linear() = Eigen::Quaterniond(raw[6], raw[3], raw[4], raw[5]).toRotationMatrix();
  std::ranges::copy(sim::val::shown_figures(pose), shown.begin());
}

void show_joints(Raw raw, Shown shown) {
  sim::Joints joints;
  for (std::size_t i = 0; i < 6; ++i) joints[static_cast<Eigen::Index>(i)] = raw[i];
  std::ranges::copy(sim::val::val_joints(joints), shown.begin());
}

template <std::size_t From>
void show_as_it_is(Raw raw, Shown shown) {
  std::copy_n(raw.begin() + From, shown.size(), shown.begin());
}

void put_pose(Shown raw, const Eigen::Vector3d& place, const Eigen::Quaterniond& turn) {
  raw[0] = place.x(), raw[1] = place.y(), raw[2] = place.z();
  raw[3] = turn.x(), raw[4] = turn.y(), raw[5] = turn.z(), raw[6] = turn.w();
}

server::Channels channels_of(sim::ToolKind tool) {
  constexpr double each_step = 1000;
  const auto numbers = Channel::Form::numbers;
  const auto pose_from = [](std::size_t at) {
    return [at](Raw raw, Shown shown) { show_pose(raw.subspan(at, 7), shown); };
  };
  const auto joints_from = [](std::size_t at) {
    return [at](Raw raw, Shown shown) { show_joints(raw.subspan(at, 6), shown); };
  };
  server::Channels result{
      {"force",
       "what acts on the force-torque sensor, tool's weight included, before its own noise; pressing is "
       "negative along z",
       {{"fx", "N"}, {"fy", "N"}, {"fz", "N"}, {"tx", "N*m"}, {"ty", "N*m"}, {"tz", "N*m"}},
       each_step,
       numbers,
       show_as_it_is<wrench_at>},
      {"pose", "where the tool's tip is", pose_fields(), each_step, numbers, pose_from(tool_at)},
      {"set-point", "where the tip has been told to be", pose_fields(), each_step, numbers,
       pose_from(set_point_at)},
      {"joints", "where the joints are", joint_fields(), each_step, numbers, joints_from(joints_at)},
      {"joint-set-points", "where the joints have been told to be", joint_fields(), each_step, numbers,
       joints_from(joint_set_points_at)},
      {"speed", "of the tip", {{"speed", "mm/s"}}, each_step, numbers, show_as_it_is<speed_at>},
      {"contacts",
       "sum of the normal forces on what the tool touches with",
       {{"force", "N"}},
       each_step,
       numbers,
       show_as_it_is<contact_at>}};
  if (tool == sim::ToolKind::gripper)
    result.push_back({"gripper",
                      "between the fingers, and with which force each presses",
                      {{"width", "mm"}, {"force", "N"}},
                      each_step,
                      numbers,
                      show_as_it_is<gripper_at>});
  if (tool == sim::ToolKind::range_finder)
    result.push_back({"profile",
                      "what the range finder gives to the skill that runs",
                      {{"y", "mm"}, {"z", "mm"}},
                      0,
                      Channel::Form::profile,
                      {},
                      {},
                      profile_marks});
  return result;
}

bool has(const server::Channel& channel, const operations::DeclaredLimit& limit) {
  return channel.name == limit.channel &&
         std::all_of(limit.fields.begin(), limit.fields.end(), [&](const std::string& field) {
           return std::any_of(channel.fields.begin(), channel.fields.end(),
                              [&](const ChannelField& each) { return each.name == field; });
         });
}

/// Throws Failure if a cell has these fields with no tool.
void check_place(const KnownSkill& skill, const operations::DeclaredLimit& limit) {
  std::set<std::string> names;
  for (const auto tool : {sim::ToolKind::pad, sim::ToolKind::gripper, sim::ToolKind::range_finder}) {
    for (const server::Channel& channel : channels_of(tool)) {
      if (has(channel, limit)) return;
      names.insert(channel.name);
      if (channel.name != limit.channel) continue;
      std::vector<std::string> fields;
      for (const ChannelField& each : channel.fields) fields.push_back(each.name);
      throw Failure(ExitStatus::wrong_specification, fmt::format("{}:{}", skill.declared_file, limit.line),
                    fmt::format("the channel '{}' has not all of these fields", limit.channel),
                    fmt::format("its fields are {}", fmt::join(fields, ", ")));
    }
  }
  throw Failure(ExitStatus::wrong_specification, fmt::format("{}:{}", skill.declared_file, limit.line),
                fmt::format("a cell has no channel '{}'", limit.channel),
                fmt::format("the channels are {}", fmt::join(names, ", ")));
}

server::ShownLimit::Kind kind_of(operations::DeclaredLimit::Kind kind) {
  using Kind = server::ShownLimit::Kind;
  switch (kind) {
    case operations::DeclaredLimit::Kind::band:
      return Kind::band;
    case operations::DeclaredLimit::Kind::stop:
      return Kind::stop;
    case operations::DeclaredLimit::Kind::error:
      return Kind::error;
    case operations::DeclaredLimit::Kind::target:
      break;
  }
  return Kind::target;
}

server::ShownLimit shown(const std::string& skill, const operations::DeclaredLimit& limit) {
  server::ShownLimit result{skill,           limit.at.parameter, limit.fields,
                            limit.at.factor, limit.both,         kind_of(limit.kind)};
  if (limit.around) result.around = {limit.around->parameter, limit.around->factor};
  return result;
}

}  // namespace

server::Channels live_channels(sim::ToolKind tool, const std::vector<KnownSkill>& skills) {
  server::Channels result = channels_of(tool);
  for (const KnownSkill& skill : skills)
    for (const operations::DeclaredLimit& limit : skill.declared.limits) {
      check_place(skill, limit);
      for (server::Channel& channel : result)
        if (channel.name == limit.channel) channel.limits.push_back(shown(skill.name, limit));
    }
  return result;
}

LiveRecorder::LiveRecorder(sim::Workcell& workcell, server::TelemetrySink& sink)
    : workcell_(workcell),
      sink_(sink),
      writer_(width, block_length,
              [&sink](std::shared_ptr<const server::SampleBlock> block) { sink.show(std::move(block)); }),
      listener_(workcell.on_sample([this](const sim::Sample& sample) {
        if (sink_.watched()) record(sample);
      })) {}

// Everything that can be worked out later is: this is called in each step of the physics.
void LiveRecorder::record(const sim::Sample& sample) {
  const runtime::Time now = workcell_.now();
  const Shown raw = writer_.record(now);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    raw[wrench_at + at] = sample.wrench.force[i];
    raw[wrench_at + 3 + at] = sample.wrench.torque[i];
  }
  put_pose(raw.subspan(tool_at), sample.tool, sample.tool_turn);
  put_pose(raw.subspan(set_point_at), sample.set_point, sample.set_point_turn);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    raw[joints_at + at] = sample.joints[i];
    raw[joint_set_points_at + at] = sample.joint_set_point[i];
  }
  constexpr double mm = 1000;
  const bool next = now - last_time_ == sim::physics_step;
  const double step_s = std::chrono::duration<double>(sim::physics_step).count();
  raw[speed_at] = next ? mm * (sample.tool - last_tool_).norm() / step_s : 0;
  raw[contact_at] = sample.contact_force;
  raw[gripper_at] = sample.gripper_width;
  raw[gripper_at + 1] = sample.grip_force;
  last_tool_ = sample.tool;
  last_time_ = now;
}

}  // namespace pal::workcell
