#include "programs/workcell/session/instruments.hpp"

#include "sim/val/transformation.hpp"
#include "skills_pal/sensing/profile.hpp"

namespace pal::workcell {

server::Telemetry telemetry_of(const sim::Workcell& workcell) {
  server::Telemetry shown;
  shown.time = workcell.now();
  const sim::Wrench wrench = workcell.wrench();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    shown.force[i] = wrench.force[axis];
    shown.force[3 + i] = wrench.torque[axis];
  }
  shown.pose = sim::val::shown_figures(workcell.tool());
  shown.joints = sim::val::val_joints(workcell.joints());
  return shown;
}

Watcher instrument_watcher(const sim::Workcell& workcell, server::TelemetrySink& sink) {
  return {std::chrono::milliseconds(20), [&workcell, &sink] {
            if (sink.wanted()) sink.show(telemetry_of(workcell));
          }};
}

void ProfileWatcher::passed(runtime::Time, const runtime::Device& device, std::size_t port,
                            std::span<const double> fields) {
  // y, z and valid of each point, then when the scan began (docs/workcell/range-finder.md).
  constexpr std::size_t count = skills::sensing::most_points;
  if (!(sink_.wanted() || sink_.watched()) || device.name() != "range-finder" ||
      device.ports()[port].message != "profile" || fields.size() != 3 * count + 1)
    return;
  server::Profile profile;
  profile.scanned = count;
  for (std::size_t i = 0; i < count; ++i) {
    if (fields[2 * count + i] == 0) {
      if (profile.missing.empty() || profile.missing.back().second != i) profile.missing.emplace_back(i, i);
      ++profile.missing.back().second;
      continue;
    }
    profile.y.push_back(fields[i]);
    profile.z.push_back(fields[count + i]);
  }
  sink_.show(station_time_(), profile);
}

}  // namespace pal::workcell
