#include "runtime/drivers/alter/driver.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace pal::runtime::drivers {
namespace {

constexpr std::size_t tick_port = 0;
constexpr std::size_t correction_port = 1;
constexpr std::size_t position_port = 3;

std::string milliseconds(Time time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g ms", static_cast<double>(time.count()) * 1e-6);
  return text.data();
}

}  // namespace

AlterDriver::AlterDriver(Timeline& timeline, Link& link, alter::Opener& opener, AlterDriverOptions options)
    : timeline_(timeline),
      link_(link),
      opener_(opener),
      options_(std::move(options)),
      ports_{
          {"tick", false, {}},
          {"correction",
           true,
           {{"dx", "mm"}, {"dy", "mm"}, {"dz", "mm"}, {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}}},
          {"request position", true, {}},
          {"position",
           false,
           {{"x", "mm"}, {"y", "mm"}, {"z", "mm"}, {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}}},
      } {
  link_.connect(this);
}

AlterDriver::~AlterDriver() {
  timeline_.cancel(silence_);
  link_.connect(nullptr);
}

// Opening and closing.

bool AlterDriver::ready() const {
  return !trouble_.empty() || state_ == (opened_by_skill_ ? State::closed : State::open);
}

void AlterDriver::prepare() {
  trouble_.clear();
  if (opened_by_skill_) return release();
  if (state_ == State::open && !opened_otherwise_) return;
  if (state_ != State::open) return open_port();
  // A skill left it open, in a mode of its own.
  timeline_.cancel(silence_);
  state_ = State::closing;
  asked_ = false;
  opener_.close([this](std::string) {
    if (state_ == State::closing) open_port();
  });
}

void AlterDriver::open_port() {
  opened_otherwise_ = false;
  decoder_.forget();
  asked_ = false;
  state_ = State::opening;
  opener_.open(options_.mode, [this](std::string problem) {
    if (state_ != State::opening) return;
    if (!problem.empty()) return fail("cannot be opened: " + problem);
    expect_request(options_.first_request_within, "was opened and asks for nothing");
  });
}

void AlterDriver::release() {
  if (state_ == State::closed) return;
  timeline_.cancel(silence_);
  state_ = State::closing;
  asked_ = false;
  opener_.close([this](std::string) {
    // Whatever was wrong with it, it is closed now.
    if (state_ == State::closing) state_ = State::closed;
  });
}

void AlterDriver::expect_request(Time within, std::string otherwise) {
  timeline_.cancel(silence_);
  silence_ = timeline_.after(within, [this, within, text = std::move(otherwise)] {
    fail(text + " for " + milliseconds(within) +
         "; is the controller switched on, and is its cable plugged in?");
  });
}

void AlterDriver::fail(std::string reason) {
  timeline_.cancel(silence_);
  trouble_ = std::move(reason);
  asked_ = false;
  const bool was_open = state_ == State::open;
  state_ = State::closed;
  // The controller may still be waiting. It stops the arm by itself when it is not answered.
  if (was_open) opener_.close([](std::string) {});
  if (host_ != nullptr) host_->fault(trouble_);
}

// The line.

void AlterDriver::on_bytes(Bytes bytes) {
  decoder_.feed(bytes);
  while (const auto found = decoder_.next()) {
    if (state_ == State::closing) continue;  // on its way when it was closed
    if (const auto* garbled = std::get_if<alter::Garbled>(&*found)) {
      if (state_ != State::closed) fail("the line is disturbed: " + garbled->why);
    } else {
      take(std::get<alter::Frame>(*found));
    }
  }
}

void AlterDriver::on_break(std::string_view reason) {
  if (state_ == State::open || state_ == State::opening) fail("the link is broken: " + std::string(reason));
}

void AlterDriver::take(const alter::Frame& frame) {
  if (const auto* request = std::get_if<alter::Request>(&frame)) {
    requested(*request);
  } else if (const auto* ended = std::get_if<alter::Ended>(&frame)) {
    ended->reason == alter::Ended::Reason::closed ? closed() : fail(ended->text);
  } else {
    fail("the controller sent an answer instead of a request; is the line looped back?");
  }
}

void AlterDriver::requested(const alter::Request& request) {
  state_ = State::open;
  opened_otherwise_ = opened_otherwise_ || opened_by_skill_;
  request_ = request;
  requested_at_ = timeline_.now();
  asked_ = true;
  expect_request(options_.silent_for, "has asked for nothing");
  if (in_session_) {
    host_->deliver(tick_port, {});
  } else {
    answer(false);
  }
}

void AlterDriver::closed() {
  timeline_.cancel(silence_);
  asked_ = false;
  if (state_ == State::open) state_ = State::closed;
}

void AlterDriver::answer(bool motion, const alter::Figures& correction) {
  asked_ = false;
  link_.write(alter::encode(alter::Answer{request_.cycle, motion, correction}));
}

Time AlterDriver::next_tick(Time from) const {
  if (state_ != State::open || from <= requested_at_) return state_ == State::open ? requested_at_ : from;
  const Time::rep cycles = (from - requested_at_ + alter::period - Time(1)) / alter::period;
  return requested_at_ + cycles * alter::period;
}

// A skill's session.

void AlterDriver::attach(DeviceHost& host) {
  host_ = &host;
  left_by_rounding_ = {};
}

void AlterDriver::receive(std::size_t port, std::span<const double> fields) {
  if (port != correction_port) {
    host_->deliver(position_port, request_.position);
  } else if (!asked_) {
    fail("got a correction that it had not asked for");
  } else {
    correct(fields);
  }
}

void AlterDriver::correct(std::span<const double> fields) {
  alter::Figures sent{};
  bool motion = false;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    if (!(std::abs(fields[i]) <= alter::greatest_correction)) {  // NaN, too
      const FieldSpec& field = ports_[correction_port].fields[i];
      return fail("cannot make the motion: " + field.name + " is " + std::to_string(fields[i]) + " " +
                  field.unit + ", a correction has at most 32.767");
    }
    // Standing still is asked for by exact zeros, and then nothing is made up for.
    const double wanted = fields[i] == 0 ? 0 : fields[i] + left_by_rounding_[i];
    sent[i] = std::round(wanted / alter::resolution) * alter::resolution;
    if (fields[i] != 0) left_by_rounding_[i] = wanted - sent[i];
    motion = motion || sent[i] != 0;
  }
  answer(motion, sent);
}

void AlterDriver::close() {
  in_session_ = false;
  host_ = nullptr;
  if (asked_) answer(false);
}

}  // namespace pal::runtime::drivers
