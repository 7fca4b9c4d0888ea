#include "runtime/drivers/force_torque/driver.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace pal::runtime::drivers {
namespace {

using force_torque::Codec;

// Ports in pairs: a request, and the answer to it.
constexpr std::size_t wrench_request = 0;
constexpr std::size_t record_request = 2;

std::vector<PortSpec> sensor_ports() {
  PortSpec wrench{
      "wrench", false, {{"fx", "N"}, {"fy", "N"}, {"fz", "N"}, {"tx", "N*m"}, {"ty", "N*m"}, {"tz", "N*m"}}};
  PortSpec record = wrench;
  record.message = "record";
  record.fields.push_back({"overload", ""});
  return {{"request wrench", true, {}}, wrench, {"request record", true, {}}, record};
}

}  // namespace

ForceTorqueDriver::ForceTorqueDriver(Timeline& timeline, Link& link, ForceTorqueDriverOptions options)
    : LinkedDriver(timeline, link, options.name, sensor_ports()), options_(std::move(options)) {
  waiting_.reserve(8);
}

bool ForceTorqueDriver::commission() {
  prepare();
  return true;
}

void ForceTorqueDriver::prepare() {
  try_again();
  // A record of the last session may still be on its way, and its bytes could pass for a prompt.
  start(codec_.asking() ? Step::drain : started_ ? Step::look : Step::boot);
}

void ForceTorqueDriver::start(Step step) {
  step_ = step;
  switch (step) {
    case Step::none:
    case Step::drain:
      return;
    case Step::boot:
      booted_ = timeline().now();
      write(codec_.boot());
      return await(options_.boot_within);
    case Step::binary:
      return command(step, "CD B");
    case Step::axes:
      return command(step, "CV 3F");
    case Step::discard:  // the first record after a start means nothing
      return ask_for_record(options_.prompt_within);
    case Step::look:
      zero_.begin_look();
      return ask_for_record(options_.record_within);
  }
}

void ForceTorqueDriver::command(Step step, std::string_view text) {
  step_ = step;
  write(codec_.command(text));
  await(options_.prompt_within);
}

void ForceTorqueDriver::ask_for_record(Time within) {
  write(codec_.request_record());
  await(within);
}

void ForceTorqueDriver::receive(std::size_t port, std::span<const double>) {
  if (port != wrench_request && port != record_request) return;
  waiting_.push_back(port);
  serve_next();
}

bool ForceTorqueDriver::withdraw(std::size_t port) {
  const auto first = waiting_.begin() + (serving_ ? 1 : 0);
  const auto found = std::find(first, waiting_.end(), port);
  if (found == waiting_.end()) return false;
  waiting_.erase(found);
  return true;
}

void ForceTorqueDriver::serve_next() {
  if (serving_ || waiting_.empty() || codec_.asking()) return;
  serving_ = true;
  host()->mark_busy(true);
  ask_for_record(options_.record_within);
}

void ForceTorqueDriver::arrived(Bytes bytes) {
  for (const std::uint8_t byte : bytes) {
    switch (codec_.feed(byte)) {
      case Codec::Progress::more:
        break;
      case Codec::Progress::garbled:
        if (step_ == Step::look && started_) return start_again();
        return fail(codec_.problem());
      case Codec::Progress::done:
        arrived_in_time();
        answered();
    }
  }
}

void ForceTorqueDriver::answered() {
  switch (step_) {
    case Step::none:
      if (serving_) return deliver();
      return;  // the session that asked is over
    case Step::drain:
      return start(started_ ? Step::look : Step::boot);
    case Step::boot:
      if (timeline().now() >= booted_ + options_.boot_takes) return start(Step::binary);
      codec_.boot();  // its bytes have been sent: only the prompt is awaited again
      return await(options_.boot_within);
    case Step::binary:
      return start(Step::axes);
    case Step::axes:
      return start(Step::discard);
    case Step::discard:
      return start(Step::look);
    case Step::look:
      zero_.look(without_weight());
      if (!zero_.looked_enough()) return ask_for_record(options_.record_within);
      started_ = true;
      if (std::string problem = zero_.end_look(); !problem.empty()) return fail(std::move(problem));
      return start(Step::none);
  }
}

force_torque::Load ForceTorqueDriver::without_weight() const {
  force_torque::Load load = codec_.record().values();
  if (!options_.tool_weight) return load;
  const force_torque::Load weight = options_.tool_weight();
  for (std::size_t i = 0; i < load.size(); ++i) load[i] -= weight[i];
  return load;
}

// The sensor has lost its power meanwhile, or its line was cut. Its zero is that of the gauges, and is kept.
void ForceTorqueDriver::start_again() {
  arrived_in_time();
  codec_.forget();
  started_ = false;
  start(Step::boot);
}

void ForceTorqueDriver::deliver() {
  force_torque::Load wrench = zero_.take_off(without_weight());
  bool overload = codec_.record().overload;
  for (std::size_t i = 0; i < wrench.size(); ++i) {
    const double range = i < 3 ? force_torque::force_range : force_torque::torque_range;
    const int count = codec_.record().counts[i];
    // An axis at its end stays there, whatever is taken off.
    if (std::abs(count) >= (i < 3 ? force_torque::greatest_force : force_torque::greatest_torque))
      wrench[i] = count > 0 ? range : -range;
    const double inside = std::clamp(wrench[i], -range, range);
    overload = overload || inside != wrench[i];
    wrench[i] = inside;
  }
  std::array<double, force_torque::axes + 1> record{};
  std::copy(wrench.begin(), wrench.end(), record.begin());
  record.back() = overload ? 1 : 0;

  const std::size_t request = waiting_.front();
  waiting_.erase(waiting_.begin());
  serving_ = false;
  host()->mark_busy(false);
  if (request == wrench_request) {
    host()->deliver(request + 1, wrench);
  } else {
    host()->deliver(request + 1, record);
  }
  if (host() != nullptr) serve_next();
}

void ForceTorqueDriver::late() {
  // The start will show whether the sensor answers.
  if (step_ == Step::drain || (step_ == Step::look && started_)) return start_again();
  LinkedDriver::late();
}

void ForceTorqueDriver::give_up() {
  codec_.forget();
  step_ = Step::none;
  started_ = false;
  serving_ = false;
  waiting_.clear();
}

void ForceTorqueDriver::close() {
  LinkedDriver::close();
  serving_ = false;
  waiting_.clear();
}

}  // namespace pal::runtime::drivers
