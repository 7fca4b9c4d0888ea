#include "sim/devices/force_torque_emulator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace pal::sim {
namespace {

using runtime::Time;

constexpr std::uint8_t control_t = 0x14;
constexpr std::uint8_t control_w = 0x17;
constexpr std::uint8_t carriage_return = 0x0d;
constexpr std::size_t longest_line = 40;
constexpr std::size_t input_room = 64;  // bytes that come while the controller is busy; more are lost
constexpr std::size_t most_biases = 3;
constexpr int conversions_of_a_bias = 16;

struct Axis {
  double range;   // N or N*m
  double counts;  // a unit
};
constexpr Axis force_axis{65, 20};
constexpr Axis torque_axis{5, 333.33};
constexpr std::array<Axis, 6> axis{force_axis, force_axis, force_axis, torque_axis, torque_axis, torque_axis};
constexpr std::size_t z_axis = 2;

}  // namespace

ForceTorqueEmulator::ForceTorqueEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link,
                                         std::function<Wrench()> load, ForceTorqueEmulatorOptions options)
    : timeline_(timeline),
      link_(link),
      load_(std::move(load)),
      options_(options),
      timing_(options.seed, 2),
      noise_(options.seed, 3) {
  draw_gauges();
  link_.connect(this);
  boot();
}

void ForceTorqueEmulator::draw_gauges() {
  Random random(options_.seed, 8);
  for (std::size_t i = 0; i < axes; ++i) {
    offset_[i] = (2 * random.unit() - 1) * (i < 3 ? options_.most_offset : options_.most_torque_offset);
    drift_[i] = (2 * random.unit() - 1) * (i < 3 ? options_.most_drift : options_.most_torque_drift);
  }
}

ForceTorqueEmulator::~ForceTorqueEmulator() {
  timeline_.cancel(work_);
  link_.connect(nullptr);
}

void ForceTorqueEmulator::boot() {
  timeline_.cancel(work_);
  input_.clear();
  line_.clear();
  streaming_ = false;
  mask_ = 0x3f;
  binary_ = false;
  biases_.clear();
  busy_for(options_.boot, [this] { ready(); });
}

void ForceTorqueEmulator::ready() {
  busy_for(send("\r\nF/T sensor, 65 N, 5 N*m\r\n>"), nullptr);
}

void ForceTorqueEmulator::on_bytes(runtime::drivers::Bytes bytes) {
  for (const std::uint8_t byte : bytes) {
    if (byte == control_w) {
      boot();
    } else if (input_.size() < input_room) {
      input_.push_back(byte);
    }
  }
  work_off();
}

void ForceTorqueEmulator::on_break(std::string_view) {
  streaming_ = false;
}

void ForceTorqueEmulator::work_off() {
  while (!busy_ && !input_.empty()) {
    const std::uint8_t byte = input_.front();
    input_.pop_front();
    take(byte);
  }
}

// One byte of what was typed; every one comes back.
void ForceTorqueEmulator::take(std::uint8_t byte) {
  const Time echoed = send(std::vector<std::uint8_t>{byte});
  if (byte == control_t) {
    return busy_for(echoed + conversion(), [this] { busy_for(send(record()), nullptr); });
  }
  if (byte != carriage_return) {
    if (line_.size() <= longest_line) line_ += static_cast<char>(byte);
    return;
  }
  obey(std::exchange(line_, {}));
}

void ForceTorqueEmulator::obey(const std::string& line) {
  const std::string word = line.substr(0, 2);
  unsigned mask = 0;
  int length = 0;
  if (line.find_first_not_of(' ') == std::string::npos) return prompt();
  if (line == "CD A" || line == "CD B") {
    binary_ = line.back() == 'B';
    return prompt();
  }
  if (word == "CV" && std::sscanf(line.c_str(), "CV %2x%n", &mask, &length) == 1 &&
      static_cast<std::size_t>(length) == line.size() && mask >= 1 && mask <= 0x3f) {
    mask_ = mask;
    return prompt();
  }
  if (line == "SB") return take_bias();
  if (line == "SU" || line == "SZ") {
    const std::size_t keep = line == "SZ" || biases_.empty() ? 0 : biases_.size() - 1;
    biases_.resize(keep);
    return prompt();
  }
  if (line == "QR") {
    return busy_for(send("\n") + conversion(), [this] { busy_for(send(record()), [this] { prompt(); }); });
  }
  if (line == "QS") {
    streaming_ = true;
    return busy_for(send("\n"), [this] { stream(); });
  }
  send("\n? " + line);
  prompt();
}

void ForceTorqueEmulator::prompt() {
  send("\r\n>");
}

void ForceTorqueEmulator::take_bias() {
  Time total{};
  for (int i = 0; i < conversions_of_a_bias; ++i) total += conversion();
  busy_for(total, [this] {
    Values mean{};
    for (int i = 0; i < conversions_of_a_bias; ++i) {
      const Values values = convert();
      for (std::size_t a = 0; a < axes; ++a) mean[a] += values[a] / conversions_of_a_bias;
    }
    for (const Values& older : biases_) {
      for (std::size_t a = 0; a < axes; ++a) mean[a] -= older[a];
    }
    if (biases_.size() == most_biases) {  // the oldest two become one
      for (std::size_t a = 0; a < axes; ++a) biases_[1][a] += biases_[0][a];
      biases_.erase(biases_.begin());
    }
    biases_.push_back(mean);
    prompt();
  });
}

// Records one after the other until a line ends; what is typed meanwhile is dropped.
void ForceTorqueEmulator::stream() {
  const auto end = std::find(input_.begin(), input_.end(), carriage_return);
  if (!streaming_ || end != input_.end()) {
    streaming_ = false;
    input_.erase(input_.begin(), end == input_.end() ? end : end + 1);
    send("\r");
    return prompt();
  }
  input_.clear();
  busy_for(conversion(), [this] { busy_for(send(record()), [this] { stream(); }); });
}

void ForceTorqueEmulator::busy_for(Time time, std::function<void()> then) {
  busy_ = true;
  work_ = timeline_.after(time, [this, then = std::move(then)] {
    busy_ = false;
    if (then) then();
    work_off();
  });
}

Time ForceTorqueEmulator::conversion() {
  return timing_.between(options_.shortest_conversion, options_.longest_conversion) + slower_by_;
}

ForceTorqueEmulator::Values ForceTorqueEmulator::convert() {
  const Wrench load = load_();
  const double minutes = std::chrono::duration<double, std::ratio<60>>(timeline_.now()).count();
  Values values{};
  for (std::size_t i = 0; i < axes; ++i) {
    const auto row = static_cast<Eigen::Index>(i % 3);
    values[i] = i < 3 ? load.force[row] + options_.force_noise * noise_.normal()
                      : load.torque[row] + options_.torque_noise * noise_.normal();
    values[i] += offset_[i] + drift_[i] * minutes;
  }
  return values;
}

ForceTorqueEmulator::Reading ForceTorqueEmulator::read() {
  const Values values = convert();
  Reading reading;
  for (std::size_t i = 0; i < axes; ++i) {
    const double range = axis[i].range;
    double value = std::clamp(values[i], -range, range);
    reading.overload = reading.overload || value != values[i];
    for (const Values& bias : biases_) value -= bias[i];
    const double inside = std::clamp(value, -range, range);
    reading.overload = reading.overload || inside != value;
    const int step = i == z_axis ? options_.z_step : 1;
    reading.counts[i] = step * static_cast<int>(std::lround(inside * axis[i].counts / step));
  }
  return reading;
}

std::vector<std::uint8_t> ForceTorqueEmulator::record() {
  const Reading reading = read();
  std::vector<std::uint8_t> bytes;
  if (binary_) {
    bytes.push_back(reading.overload ? 1 : 0);
  } else {
    bytes.push_back(reading.overload ? '1' : '0');
  }
  for (std::size_t i = 0; i < axes; ++i) {
    if ((mask_ >> i & 1U) == 0) continue;
    if (binary_) {
      const auto word = static_cast<std::uint16_t>(reading.counts[i]);
      bytes.push_back(static_cast<std::uint8_t>(word >> 8));
      bytes.push_back(static_cast<std::uint8_t>(word & 0xff));
    } else {
      std::array<char, 16> text{};
      const int length = std::snprintf(text.data(), text.size(), ",%6d", reading.counts[i]);
      bytes.insert(bytes.end(), text.begin(), text.begin() + length);
    }
  }
  if (!binary_) bytes.insert(bytes.end(), {'\r', '\n'});
  return bytes;
}

Time ForceTorqueEmulator::send(const std::vector<std::uint8_t>& bytes) {
  link_.write(bytes);
  sending_until_ = std::max(sending_until_, timeline_.now()) + options_.line.duration(bytes.size());
  return sending_until_ - timeline_.now();
}

Time ForceTorqueEmulator::send(std::string_view text) {
  return send(std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace pal::sim
