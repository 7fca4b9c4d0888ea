// The cell's instruments, for observers outside.
#pragma once

#include <functional>
#include <span>

#include "pal/runtime/observer.hpp"
#include "programs/workcell/session/watched_world.hpp"
#include "server/telemetry.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {

/// What the instruments show now.
server::Telemetry telemetry_of(const sim::Workcell& workcell);

/// If the sink has observers, shows it the instruments every 20 ms of station time.
Watcher instrument_watcher(const sim::Workcell& workcell, server::TelemetrySink& sink);

/// Shows the sink each profile that the range finder gives to a skill.
class ProfileWatcher final : public runtime::MessageObserver {
 public:
  /// The sink outlives it. `station_time`: the station's instant.
  ProfileWatcher(server::TelemetrySink& sink, std::function<Duration()> station_time)
      : sink_(sink), station_time_(std::move(station_time)) {}
  void passed(runtime::Time when, const runtime::Device& device, std::size_t port,
              std::span<const double> fields) override;

 private:
  server::TelemetrySink& sink_;
  std::function<Duration()> station_time_;
};

}  // namespace pal::workcell
