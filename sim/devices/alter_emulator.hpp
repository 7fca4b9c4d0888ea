// The robot controller's ALTER port, at the far end of its line. It asks for a relative motion every 28 ms,
// and moves the arm by it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/drivers/alter/codec.hpp"
#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"
#include "sim/controller/correction.hpp"
#include "sim/devices/alter_control.hpp"

namespace pal::sim {

/// The arm that the port moves.
class AlterArm {
 public:
  virtual ~AlterArm() = default;
  /// Corrections of this kind are about to begin. Empty: the arm takes them; otherwise why not.
  virtual std::string open(const AlterMode& mode) = 0;
  /// A correction to be made evenly from `begin` on, over one cycle. Refused: why; the arm stops then.
  virtual std::optional<std::string> move(const Correction& correction, runtime::Time begin) = 0;
  virtual void stop() = 0;
  /// Why the arm stopped by itself; empty: it did not.
  virtual std::string fault() const = 0;
  virtual bool moving() const = 0;
  /// Where the controller believes the tip to be.
  virtual Pose tool() const = 0;
};

/// Speaks the protocol of docs/workcell/alter.md. Closed until AlterControl opens it. The first cycle begins
/// one period after that.
///
/// A correction that answers the request of one cycle is moved evenly in the next cycle. Between its answer
/// and the next request the controller computes the joint set-points. Bytes that are no answer are ignored.
///
/// These end ALTER and stop the arm at once, and the far end is told why:
/// - no answer in time, or an answer that was not asked for;
/// - a motion that the arm cannot make;
/// - a fault of the arm.
class AlterEmulator final : public AlterControl, private runtime::drivers::LinkUser {
 public:
  /// What is given outlives the emulator.
  AlterEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link, AlterArm& arm);
  ~AlterEmulator() override;
  AlterEmulator(const AlterEmulator&) = delete;
  AlterEmulator& operator=(const AlterEmulator&) = delete;

  std::string open(const AlterMode& mode) override;
  std::string close() override;
  bool is_open() const override { return open_; }
  void on_end(std::function<void(const std::string& why)> tell) override { tell_ = std::move(tell); }

  /// To be called when the arm stops by itself; the port finds out at its next cycle otherwise.
  void arm_has_stopped();

 private:
  void on_bytes(runtime::drivers::Bytes bytes) override;
  void on_break(std::string_view reason) override;
  void cycle();
  void take(const runtime::drivers::alter::Answer& answer);
  void answer_is_late();
  void silence();
  void end(runtime::drivers::alter::Ended::Reason reason, std::string text);

  runtime::drivers::Timeline& timeline_;
  runtime::drivers::Link& link_;
  AlterArm& arm_;
  runtime::drivers::alter::Decoder decoder_;
  bool open_ = false;
  bool unanswered_ = false;
  bool garbled_ = false;  // something came in this cycle that was no answer
  std::uint8_t cycle_ = 0;
  runtime::Time began_{};
  runtime::drivers::Timeline::Token next_cycle_;
  runtime::drivers::Timeline::Token deadline_;
  std::string ended_because_;
  std::function<void(const std::string& why)> tell_;
};

}  // namespace pal::sim
