#include "sim/devices/alter_emulator.hpp"

#include <cmath>
#include <utility>

#include "runtime/drivers/linked_driver.hpp"

namespace pal::sim {
namespace {

namespace alter = runtime::drivers::alter;
using Reason = alter::Ended::Reason;

// The angles of a turn about x, then y, then z.
alter::Figures figures_of(const Pose& pose) {
  const Eigen::Vector3d position = pose.translation() * 1e3;
  const Eigen::Matrix3d r = pose.linear();
  return {position.x(),
          position.y(),
          position.z(),
          degrees(std::atan2(r(2, 1), r(2, 2))),
          degrees(std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)))),
          degrees(std::atan2(r(1, 0), r(0, 0)))};
}

}  // namespace

AlterEmulator::AlterEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link,
                             AlterArm& arm)
    : timeline_(timeline), link_(link), arm_(arm) {
  link_.connect(this);
}

AlterEmulator::~AlterEmulator() {
  timeline_.cancel(next_cycle_);
  timeline_.cancel(deadline_);
  link_.connect(nullptr);
}

std::string AlterEmulator::open(const AlterMode& mode) {
  if (open_) return "ALTER is open already";
  if (std::string fault = arm_.fault(); !fault.empty()) return "the arm is stopped: " + fault;
  if (std::string refused = arm_.open(mode); !refused.empty()) return refused;
  open_ = true;
  unanswered_ = false;
  ended_because_.clear();
  decoder_.forget();
  next_cycle_ = timeline_.after(alter::period, [this] { cycle(); });
  return {};
}

std::string AlterEmulator::close() {
  if (open_) {
    silence();
    link_.write(alter::encode(alter::Ended{Reason::closed, "closed"}));
  }
  return std::exchange(ended_because_, {});
}

void AlterEmulator::silence() {
  timeline_.cancel(next_cycle_);
  timeline_.cancel(deadline_);
  open_ = unanswered_ = false;
}

void AlterEmulator::cycle() {
  if (std::string fault = arm_.fault(); !fault.empty()) return end(Reason::arm_fault, std::move(fault));
  began_ = timeline_.now();
  ++cycle_;
  unanswered_ = true;
  garbled_ = false;
  link_.write(alter::encode(alter::Request{cycle_, arm_.moving(), figures_of(arm_.tool())}));
  deadline_ = timeline_.at(began_ + alter::answer_within, [this] { answer_is_late(); });
  next_cycle_ = timeline_.at(began_ + alter::period, [this] { cycle(); });
}

void AlterEmulator::on_bytes(runtime::drivers::Bytes bytes) {
  decoder_.feed(bytes);
  while (const auto found = decoder_.next()) {
    const auto* frame = std::get_if<alter::Frame>(&*found);
    const auto* answer = frame == nullptr ? nullptr : std::get_if<alter::Answer>(frame);
    if (answer == nullptr) {
      garbled_ = true;
    } else if (open_) {
      take(*answer);
    }
  }
}

void AlterEmulator::on_break(std::string_view) {
  // A controller does not notice that its cable was unplugged: it is not answered, which it does notice.
}

void AlterEmulator::take(const alter::Answer& answer) {
  if (!unanswered_ || answer.cycle != cycle_)
    return end(Reason::unasked, "got a correction that it had not asked for");
  unanswered_ = false;
  timeline_.cancel(deadline_);
  if (!answer.motion) return;
  const auto& by = answer.correction;
  const Correction correction{by[0], by[1], by[2], by[3], by[4], by[5]};
  if (auto refused = arm_.move(correction, began_ + alter::period))
    end(Reason::impossible, "cannot make the motion: " + *refused);
}

void AlterEmulator::answer_is_late() {
  std::string text = "got no correction within " + runtime::drivers::in_milliseconds(alter::answer_within) +
                     " of the beginning of its cycle";
  if (garbled_) text += "; what came was garbled";
  end(Reason::late, std::move(text));
}

void AlterEmulator::arm_has_stopped() {
  if (open_) end(Reason::arm_fault, arm_.fault());
}

void AlterEmulator::end(Reason reason, std::string text) {
  silence();
  arm_.stop();
  link_.write(alter::encode(alter::Ended{reason, text}));
  ended_because_ = std::move(text);
  if (tell_) tell_(ended_because_);
}

}  // namespace pal::sim
