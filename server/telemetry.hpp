// The readings of the cell's instruments while it works.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "pal/support/time.hpp"
#include "server/channels.hpp"

namespace pal::server {

/// The range finder's last profile: points in the tool's YZ plane, mm; only those that have a range, in the
/// order of the scan.
struct Profile {
  std::vector<double> y, z;
  std::size_t scanned = 0;  // points of the scan
  /// Stretches [from, to) of the scan that had no range.
  std::vector<std::pair<std::size_t, std::size_t>> missing{};
  std::vector<ProfileMark> marks{};  // filled in by the server's thread
};

struct Telemetry {
  Duration time{};  // of the cell
  /// N and N*m in the frame of the force-torque sensor, as the world acts on it.
  std::array<double, 6> force{};
  std::array<double, 6> pose{};    // of the tool's tip: x, y, z in mm, then O, A, T in degrees
  std::array<double, 6> joints{};  // degrees
};

/// Gets what the instruments show. The simulation calls it: it must be quick and must not throw.
class TelemetrySink {
 public:
  virtual ~TelemetrySink() = default;
  /// Whether a client observes; otherwise the instruments need not be read.
  virtual bool wanted() const noexcept = 0;
  virtual void show(const Telemetry& telemetry) = 0;
  virtual void show(Duration time, const Profile& profile) = 0;
  /// Whether a client watches channels; otherwise no records need be written.
  virtual bool watched() const noexcept { return false; }
  virtual void show(std::shared_ptr<const SampleBlock>) {}
  /// In the order of their times.
  virtual void show(std::vector<std::shared_ptr<const Rows>>) {}
};

}  // namespace pal::server
