#include "sim/devices/force_torque_sensor.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace pal::sim {
namespace {

constexpr std::size_t request_port = 0;
constexpr std::size_t wrench_port = 1;

struct Axis {
  const char* name;
  const char* unit;
  double counts;  // a unit
  double range;   // units
};

constexpr std::array<Axis, 6> axes{{{"fx", "N", 20, 65},
                                    {"fy", "N", 20, 65},
                                    {"fz", "N", 20, 65},
                                    {"tx", "N*m", 333.33, 5},
                                    {"ty", "N*m", 333.33, 5},
                                    {"tz", "N*m", 333.33, 5}}};

std::string overload(const Axis& axis, double value) {
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "is overloaded: %s is %.1f %s, its range is %.0f to %.0f %s",
                axis.name, value, axis.unit, -axis.range, axis.range, axis.unit);
  return text.data();
}

std::vector<runtime::PortSpec> sensor_ports() {
  runtime::PortSpec wrench{"wrench", false, {}};
  for (const Axis& axis : axes) wrench.fields.push_back({axis.name, axis.unit});
  return {{"request wrench", true, {}}, wrench};
}

}  // namespace

ForceTorqueSensor::ForceTorqueSensor(const Workcell& workcell, ForceTorqueOptions options)
    : workcell_(workcell),
      options_(std::move(options)),
      ports_(sensor_ports()),
      timing_(options_.seed, 2),
      noise_(options_.seed, 3) {}

void ForceTorqueSensor::attach(runtime::DeviceHost& host) {
  host_ = &host;
}

void ForceTorqueSensor::open() {
  zero_ = workcell_.wrench();
  waiting_ = 0;
  busy_ = false;
}

void ForceTorqueSensor::receive(std::size_t port, std::span<const double>) {
  if (port != request_port) return;
  ++waiting_;
  if (!busy_) begin();
}

bool ForceTorqueSensor::withdraw(std::size_t port) {
  if (port == request_port && waiting_ > 0) --waiting_;
  return true;
}

void ForceTorqueSensor::begin() {
  --waiting_;
  busy_ = true;
  host_->mark_busy(true);
  const std::uint32_t serial = ++serial_;
  host_->at(host_->now() + timing_.between(options_.shortest, options_.longest),
            [this, serial] { finish(serial); });
}

void ForceTorqueSensor::finish(std::uint32_t serial) {
  if (!busy_ || serial != serial_) return;
  busy_ = false;
  host_->mark_busy(false);
  const Wrench now = workcell_.wrench();
  const Eigen::Vector3d force = now.force - zero_.force;
  const Eigen::Vector3d torque = now.torque - zero_.torque;
  std::array<double, 6> fields{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool is_force = i < 3;
    const auto row = static_cast<Eigen::Index>(i % 3);
    const double noise = (is_force ? options_.force_noise : options_.torque_noise) * noise_.normal();
    const double value = (is_force ? force[row] : torque[row]) + noise;
    if (std::abs(value) > axes[i].range) return host_->fault(overload(axes[i], value));
    fields[i] = std::round(value * axes[i].counts) / axes[i].counts;
  }
  host_->deliver(wrench_port, fields);
  if (waiting_ > 0 && !busy_) begin();
}

void ForceTorqueSensor::close() {
  ++serial_;
  waiting_ = 0;
  busy_ = false;
}

}  // namespace pal::sim
