// The NRC's laser range finder, at the far end of a line.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/range_finder/protocol.hpp"
#include "runtime/drivers/timeline.hpp"
#include "sim/arm/kinematics.hpp"
#include "sim/random.hpp"

namespace pal::sim {

/// What the range finder sees.
struct RangeView {
  /// Where its origin is now, in frame 0, m: the fan lies in its y-z plane, z points at what is measured.
  std::function<Pose()> pose;
  /// How far a ray goes (frame 0, m; the direction has length 1) until it meets something; nothing: it meets
  /// nothing.
  std::function<std::optional<double>(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)> cast;
};

struct RangeFinderEmulatorOptions {
  std::uint64_t seed = 1;
  /// From INIT until the mirror swings and the first scan begins; in addition the phase, drawn by the seed if
  /// not given.
  runtime::Time start = std::chrono::milliseconds(250);
  std::optional<runtime::Time> phase = std::nullopt;  // in [0, 78 ms)
  double field_of_view = 40;                          // deg, from the first point to the last
  // Where z is valid, mm.
  double nearest = 100;
  double farthest = 1000;
  /// Surfaces that are met more steeply send nothing back (angle from the normal, in the plane of the fan;
  /// deg; ours).
  double steepest = 75;
  /// The stated error is taken as twice the standard deviation, and as the limit. 0: no errors.
  double error_scale = 1;
};

/// The stated error at a distance, mm (thesis, section 5.4.1.2: 0.1 below 150 mm, 0.2 at 250, 2 at 850, 20 at
/// 1000; the logarithm of the error is linear in between). `z` in mm.
double range_error(double z);

/// Speaks the protocol of docs/workcell/range-finder.md: INIT, PROFILE. Rays are cast while the scan goes on,
/// three or four a millisecond, from the arm's current place. They are cast only if the profile was asked
/// for.
class RangeFinderEmulator final : public runtime::drivers::LinkUser {
 public:
  /// All that is given outlives the emulator.
  RangeFinderEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link, RangeView view,
                      RangeFinderEmulatorOptions options = {});
  RangeFinderEmulator(const RangeFinderEmulator&) = delete;
  RangeFinderEmulator& operator=(const RangeFinderEmulator&) = delete;
  ~RangeFinderEmulator() override;

  void on_bytes(runtime::drivers::Bytes bytes) override;
  void on_break(std::string_view) override { line_.clear(); }

 private:
  /// A point in the fan, mm; nothing where nothing valid came back.
  struct Point {
    double y = 0;
    double z = 0;
  };

  void obey(const std::string& line);
  void start();
  void swing();
  void begin_scan();
  void take_requests();
  void scan_step();
  void cast_point(const Pose& pose);
  std::optional<Point> meet(const Pose& pose, double angle) const;
  bool too_steep(const Point& before, const Point& here) const;
  std::string measured(const Point& point);
  double angle(std::size_t point) const;
  runtime::Time last_step() const;
  std::int64_t clock(runtime::Time instant) const;
  void send(std::string_view text);

  runtime::drivers::Timeline& timeline_;
  runtime::drivers::Link& link_;
  RangeView view_;
  RangeFinderEmulatorOptions options_;
  Random phase_;
  Random noise_;

  std::string line_;  // typed so far
  bool swinging_ = false;
  runtime::drivers::Timeline::Token next_scan_;
  runtime::drivers::Timeline::Token next_step_;
  runtime::Time started_{};  // INIT
  runtime::Time swinging_since_{};
  runtime::Time scan_began_{};
  int asked_ = 0;  // requests since the last scan began
  std::size_t next_point_ = 0;
  std::optional<Point> before_;  // the point before that
  bool steep_before_ = false;    // between that one and the one before it the surface was too steep
  std::string text_;             // points that have been measured and not sent
  runtime::drivers::range_finder::Checksum sum_;
};

}  // namespace pal::sim
