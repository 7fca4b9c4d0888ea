#include "sim/devices/alter_port.hpp"

#include "sim/random.hpp"

namespace pal::sim {
namespace {

constexpr std::size_t tick_port = 0;
constexpr std::size_t correction_port = 1;

std::string milliseconds(runtime::Time time) {
  const std::string text = std::to_string(static_cast<double>(time.count()) / 1e6);
  return text.substr(0, text.find('.') + 2) + " ms";
}

}  // namespace

AlterPort::AlterPort(Workcell& workcell, AlterOptions options)
    : workcell_(workcell),
      options_(std::move(options)),
      ports_{{"tick", false, {}},
             {"correction",
              true,
              {{"dx", "mm"}, {"dy", "mm"}, {"dz", "mm"}, {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}}}} {
  Random random(options_.seed, 1);
  phase_ = options_.phase.value_or(random.between(runtime::Time::zero(), alter_period));
}

void AlterPort::attach(runtime::DeviceHost& host) {
  host_ = &host;
}

void AlterPort::open() {
  open_ = true;
  unanswered_ = false;
  host_->at(host_->now() + phase_, [this] { tick(); });
}

void AlterPort::tick() {
  if (!open_) return;
  last_tick_ = host_->now();
  unanswered_ = true;
  const std::uint32_t serial = ++serial_;
  host_->at(last_tick_ + options_.answer_within, [this, serial] { expect_answer(serial); });
  host_->at(last_tick_ + alter_period, [this] { tick(); });
  host_->deliver(tick_port, {});
}

void AlterPort::expect_answer(std::uint32_t serial) {
  if (open_ && unanswered_ && serial == serial_)
    fail("got no correction within " + milliseconds(options_.answer_within) + " of its request");
}

void AlterPort::receive(std::size_t port, std::span<const double> fields) {
  if (!open_ || port != correction_port) return;
  if (!unanswered_) return fail("got a correction that it had not asked for");
  unanswered_ = false;
  const Correction correction{fields[0], fields[1], fields[2], fields[3], fields[4], fields[5]};
  if (auto refused = workcell_.move(correction, options_.frame, last_tick_ + alter_period))
    fail("cannot make the motion: " + *refused);
}

void AlterPort::fail(std::string reason) {
  open_ = false;
  workcell_.stop();
  host_->fault(std::move(reason));
}

void AlterPort::close() {
  open_ = false;
}

}  // namespace pal::sim
