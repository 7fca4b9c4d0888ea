#include "sim/report/log_table.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <optional>
#include <ostream>
#include <sstream>

#include "sim/arm/puma.hpp"

namespace pal::sim {
namespace {

using Text = fmt::memory_buffer;

template <class... Values>
void append(Text& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

// Arrays, such as the points of a profile, do not fit into a line.
bool has_column(const runtime::FieldSpec& field) {
  return field.count == 1;
}

void header(Text& text, const MessageLog& messages) {
  append(text, "time_ms");
  for (const char* kind : {"", "_set_point"})
    for (std::size_t joint = 1; joint <= joint_count; ++joint) append(text, ",joint{}{}_deg", joint, kind);
  for (const char* what : {"tool", "set_point"}) {
    for (const char axis : {'x', 'y', 'z'}) append(text, ",{}_{}_mm", what, axis);
    for (const char axis : {'x', 'y', 'z'}) append(text, ",{}_r{}_deg", what, axis);
  }
  append(text,
         ",contact_force_N,wrench_fx_N,wrench_fy_N,wrench_fz_N,wrench_tx_N*m,wrench_ty_N*m,wrench_tz_N*m,"
         "grip_force_N,gripper_width_mm");
  for (const MessageLog::DeviceNames& device : messages.devices())
    for (const runtime::PortSpec& port : device.ports)
      for (const runtime::FieldSpec& field : port.fields)
        if (has_column(field))
          append(text, ",{}.{}.{}{}{}", device.name, port.message, field.name, field.unit.empty() ? "" : "_",
                 field.unit);
  append(text, "\n");
}

void pose(Text& text, const Eigen::Vector3d& place, const Eigen::Quaterniond& turn) {
  const Eigen::Vector3d angles = turn_angles(turn);
  append(text, ",{:.4f},{:.4f},{:.4f},{:.5f},{:.5f},{:.5f}", place.x() * 1e3, place.y() * 1e3,
         place.z() * 1e3, angles.x(), angles.y(), angles.z());
}

void arm_columns(Text& text, const Sample& sample) {
  append(text, "{}", std::chrono::duration_cast<std::chrono::milliseconds>(sample.time).count());
  for (const Joints* joints : {&sample.joints, &sample.joint_set_point})
    for (const double angle : *joints) append(text, ",{:.5f}", degrees(angle));
  pose(text, sample.tool, sample.tool_turn);
  pose(text, sample.set_point, sample.set_point_turn);
  append(text, ",{:.4f}", sample.contact_force);
  for (const double force : sample.wrench.force) append(text, ",{:.4f}", force);
  for (const double torque : sample.wrench.torque) append(text, ",{:.5f}", torque);
  append(text, ",{:.4f},{:.3f}", sample.grip_force, sample.gripper_width);
}

// The latest message of each port with fields, as it stands at one sample after the other.
class LatestMessages {
 public:
  explicit LatestMessages(const MessageLog& messages)
      : messages_(messages), reader_(messages), next_(reader_.next()) {
    for (const MessageLog::DeviceNames& device : messages.devices())
      latest_.emplace_back(device.ports.size());
  }

  void up_to(runtime::Time time) {
    for (; next_ != nullptr && next_->time <= time; next_ = reader_.next())
      latest_[next_->device][next_->port] = next_->fields;
  }

  void write(Text& text) const {
    for (std::size_t device = 0; device < latest_.size(); ++device)
      for (std::size_t port = 0; port < latest_[device].size(); ++port)
        write(text, latest_[device][port], messages_.devices()[device].ports[port].fields);
  }

 private:
  /// No values: there was no message yet.
  static void write(Text& text, const std::vector<double>& values,
                    const std::vector<runtime::FieldSpec>& fields) {
    std::size_t place = 0;  // of the field's first value in the message
    for (const runtime::FieldSpec& field : fields) {
      if (has_column(field) && values.empty()) append(text, ",");
      if (has_column(field) && !values.empty()) append(text, ",{:.6g}", values[place]);
      place += field.count;
    }
  }

  const MessageLog& messages_;
  MessageLog::Reader reader_;
  const LoggedMessage* next_;
  std::vector<std::vector<std::vector<double>>> latest_;  // values, by device and port
};

}  // namespace

Eigen::Vector3d turn_angles(const Eigen::Quaterniond& turn) {
  const Eigen::Matrix3d r = turn.toRotationMatrix();
  const double x = degrees(std::atan2(r(2, 1), r(2, 2)));
  return {x < -90 ? x + 360 : x, degrees(std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)))),
          degrees(std::atan2(r(1, 0), r(0, 0)))};
}

void write_log_table(const SampleSource& samples, const MessageLog& messages, std::ostream& out) {
  Text text;
  header(text, messages);
  LatestMessages latest(messages);
  samples([&](const Sample& sample) {
    latest.up_to(sample.time);
    arm_columns(text, sample);
    latest.write(text);
    append(text, "\n");
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  });
  out.write(text.data(), static_cast<std::streamsize>(text.size()));  // the header alone
}

std::string log_table(const std::vector<Sample>& log, const MessageLog& messages) {
  std::ostringstream out;
  write_log_table(samples_of(log), messages, out);
  return out.str();
}

}  // namespace pal::sim
