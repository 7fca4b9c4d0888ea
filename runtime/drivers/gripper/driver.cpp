#include "runtime/drivers/gripper/driver.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace pal::runtime::drivers {
namespace {

constexpr std::size_t state_request = 0;
constexpr std::size_t state_port = 1;
constexpr std::size_t longest_line = 60;

std::vector<PortSpec> gripper_ports() {
  return {{"request state", true, {}}, {"state", false, {{"width", "mm"}, {"force", "N"}, {"holding", ""}}}};
}

}  // namespace

GripperDriver::GripperDriver(Timeline& timeline, Link& link, GripperDriverOptions options)
    : LinkedDriver(timeline, link, options.name, gripper_ports()), options_(std::move(options)) {}

void GripperDriver::prepare() {
  try_again();
  preparing_ = true;
  if (!asking_) ask();  // else an answer of the last session is on its way, and says as much
}

void GripperDriver::ask() {
  asking_ = true;
  line_.clear();
  write(as_bytes("STATE\r"));
  await(options_.answer_within);
}

void GripperDriver::receive(std::size_t port, std::span<const double>) {
  if (port != state_request) return;
  ++waiting_;
  serve_next();
}

bool GripperDriver::withdraw(std::size_t port) {
  if (port != state_request || waiting_ == 0) return false;
  --waiting_;
  return true;
}

void GripperDriver::serve_next() {
  if (asking_ || waiting_ == 0) return;
  --waiting_;
  serving_ = true;
  host()->mark_busy(true);
  ask();
}

void GripperDriver::arrived(Bytes bytes) {
  for (const std::uint8_t byte : bytes) {
    if (!asking_) return fail("sends " + shown({&byte, 1}) + " without being asked");
    if (byte == '\n') {
      arrived_in_time();
      asking_ = false;
      take(std::exchange(line_, {}));
      if (!trouble().empty()) return;
    } else if (line_.size() == longest_line) {
      return fail("answers without end: " + shown(as_bytes(line_)));
    } else if (byte != '\r') {
      line_ += static_cast<char>(byte);
    }
  }
}

void GripperDriver::take(const std::string& line) {
  std::array<double, 3> state{};
  int holding = 0;
  int length = 0;
  const int found =
      std::sscanf(line.c_str(), "STATE %lf %lf %1d%n", state.data(), &state[1], &holding, &length);
  if (found != 3 || static_cast<std::size_t>(length) != line.size() || (holding != 0 && holding != 1)) {
    return fail("answers " + shown(as_bytes(line)) + " to STATE");
  }
  state[2] = holding;
  preparing_ = false;
  if (!std::exchange(serving_, false)) return;
  host()->mark_busy(false);
  host()->deliver(state_port, state);
  if (host() != nullptr) serve_next();
}

std::string GripperDriver::missing() const {
  return line_.empty() ? "no answer to STATE came" : "only " + shown(as_bytes(line_)) + " came of an answer";
}

void GripperDriver::give_up() {
  asking_ = false;
  serving_ = false;
  preparing_ = false;
  waiting_ = 0;
  line_.clear();
}

void GripperDriver::close() {
  LinkedDriver::close();
  serving_ = false;
  waiting_ = 0;
}

}  // namespace pal::runtime::drivers
