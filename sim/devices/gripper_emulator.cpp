#include "sim/devices/gripper_emulator.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace pal::sim {
namespace {

constexpr std::size_t longest_gripper_line = 40;

}  // namespace

GripperEmulator::GripperEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link,
                                 std::function<GripperState()> state, GripperEmulatorOptions options)
    : timeline_(timeline),
      link_(link),
      state_(std::move(state)),
      options_(options),
      timing_(options.seed, 6),
      noise_(options.seed, 7) {
  link_.connect(this);
}

GripperEmulator::~GripperEmulator() {
  timeline_.cancel(work_);
  link_.connect(nullptr);
}

void GripperEmulator::on_bytes(runtime::drivers::Bytes bytes) {
  for (const std::uint8_t byte : bytes) {
    if (byte == '\r') {
      obey(std::exchange(line_, {}));
    } else if (byte != '\n' && line_.size() < longest_gripper_line) {
      line_ += static_cast<char>(byte);
    }
  }
}

// A question that comes before the last one was answered takes its place.
void GripperEmulator::obey(const std::string& line) {
  timeline_.cancel(work_);
  if (line != "STATE") return link_.write(runtime::drivers::as_bytes("? " + line + "\r\n"));
  const runtime::Time wait = timing_.between(options_.shortest_wait, options_.longest_wait) + slower_by_;
  work_ = timeline_.after(wait, [this] { answer(); });
}

void GripperEmulator::answer() {
  const GripperState state = state_();
  const double width = std::clamp(state.width + options_.width_noise * noise_.normal(), 0.0, 999.0);
  const double force = std::clamp(state.force + options_.force_noise * noise_.normal(), 0.0, 999.0);
  std::array<char, 40> text{};
  const int length = std::snprintf(text.data(), text.size(), "STATE %06.2f %05.1f %d\r\n", width, force,
                                   state.holding ? 1 : 0);
  link_.write(runtime::drivers::as_bytes({text.data(), static_cast<std::size_t>(length)}));
}

}  // namespace pal::sim
