// The driver of the robot controller's ALTER port.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/drivers/alter/codec.hpp"
#include "runtime/drivers/alter/opener.hpp"
#include "runtime/drivers/driver.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {

struct AlterDriverOptions {
  std::string name = "alter";
  alter::Mode mode;
  /// From opening to the controller's first request.
  Time first_request_within = std::chrono::seconds(1);
  /// A controller that asks for nothing for this long is switched off, or its cable is unplugged.
  Time silent_for = std::chrono::milliseconds(60);
};

/// Ports:
/// - `tick` from the device, one for each request of the controller;
/// - `correction` to it: dx, dy, dz in mm, rx, ry, rz in deg;
/// - `request position` to it, answered at once by `position`: x, y, z in mm, rx, ry, rz in deg. This is the
///   tool's tip in frame 0, as the controller's last request gave it.
///
/// prepare() opens ALTER, release() closes it. While it is open each request is answered: in a session by the
/// skill's correction, otherwise by no motion. The part of a correction that is lost by rounding to the
/// line's resolution is added to the next one. So thousands of small corrections do not drift.
class AlterDriver final : public Driver, private LinkUser {
 public:
  /// What is given outlives the driver.
  AlterDriver(Timeline& timeline, Link& link, alter::Opener& opener, AlterDriverOptions options = {});
  ~AlterDriver() override;
  AlterDriver(const AlterDriver&) = delete;
  AlterDriver& operator=(const AlterDriver&) = delete;

  const std::string& name() const override { return options_.name; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override;
  void open() override { in_session_ = true; }
  void receive(std::size_t port, std::span<const double> fields) override;
  void close() override;

  void prepare() override;
  bool ready() const override;
  void release() override;
  bool released() const override { return state_ == State::closed; }
  std::string trouble() const override { return trouble_; }

  /// The skill itself opens and closes ALTER, by other means. So prepare() closes it, and a request that
  /// comes later opens the session. The next skill that does not open it itself finds it in
  /// the mode of this driver's options.
  void leave_opening_to_skill(bool leave) { opened_by_skill_ = leave; }

  /// The first instant at or after `from` at which a request is expected; `from` itself if ALTER is not open.
  Time next_tick(Time from) const;

 private:
  enum class State { closed, opening, open, closing };

  void open_port();
  void on_bytes(Bytes bytes) override;
  void on_break(std::string_view reason) override;
  void take(const alter::Frame& frame);
  void requested(const alter::Request& request);
  void closed();
  void correct(std::span<const double> fields);
  void answer(bool motion, const alter::Figures& correction = {});
  void expect_request(Time within, std::string otherwise);
  void fail(std::string reason);

  Timeline& timeline_;
  Link& link_;
  alter::Opener& opener_;
  AlterDriverOptions options_;
  std::vector<PortSpec> ports_;
  alter::Decoder decoder_;
  DeviceHost* host_ = nullptr;
  bool in_session_ = false;
  bool opened_by_skill_ = false;
  bool opened_otherwise_ = false;  // it is open as a skill opened it
  State state_ = State::closed;
  std::string trouble_;
  bool asked_ = false;  // the controller waits for an answer
  alter::Request request_;
  Time requested_at_{};
  alter::Figures left_by_rounding_{};
  Timeline::Token silence_;
};

}  // namespace pal::runtime::drivers
