#include "tests/run/skills/bench/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "sim/contact_stiffness.hpp"
#include "tests/run/skills/bench/press_runs.hpp"
#include "tests/run/skills/bench/touch_runs.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

namespace pal::test {

namespace {

struct Cause {
  const char* words;
  const char* lines;  // of the scene
};
constexpr std::array causes{Cause{"as it is", "machine seed 1"},
                            Cause{"sensors exact", "sensors exact"},
                            Cause{"machine without play", "machine without play"},
                            Cause{"machine without counts", "machine without counts"},
                            Cause{"machine exact", "machine exact"},
                            Cause{"machine exact, sensors exact", "machine exact\nsensors exact"}};

void write_press_causes(std::ostream& out) {
  out << "press, 5 N for 2 s, seeds 1 to 5, rms and greatest error in N:\n\n"
         "| | plate-1 | plate-5 | plate-20 | touch |\n| --- | --- | --- | --- | --- |\n";
  for (const Cause& cause : causes) {
    out << "| " << cause.words;
    for (const char* plate : {"plate-1", "plate-5", "plate-20", "touch"}) {
      const Held held = press_runs(plate, cause.lines);
      out << fmt::format(" | {:.3f}, {:.2f}{}", held.rms, held.greatest, held.ended ? "" : " (not ended)");
    }
    out << " |\n";
  }
}

void write_touch_causes(std::ostream& out) {
  out << "\ntouch at 40 mm/s, scene touch, 25 phases, overshoot in N:\n\n"
         "| | peak | felt by the sensor | at rest |\n| --- | --- | --- | --- |\n";
  for (const Cause& cause : causes) {
    const ChangedScene changed("touch", cause.lines);
    const Overshoot overshoot = touch_runs(changed.scene(), 40);
    out << fmt::format("| {} | {:.1f} to {:.1f} | {:.1f} to {:.1f} | {:.1f} to {:.1f} |\n", cause.words,
                       overshoot.peak.least, overshoot.peak.greatest, overshoot.felt.least,
                       overshoot.felt.greatest, overshoot.resting.least, overshoot.resting.greatest);
  }
}

// 2 mm into what stands 15 mm below, by corrections of one speed; then half a second of rest.
void write_pushes(std::ostream& out) {
  constexpr double way = 15 + 2;  // mm
  out << "\nno skill, machine exact, 2 mm into the plate at once, contact force in N:\n\n"
         "| scene | speed | peak | at rest | peak above rest |\n| --- | --- | --- | --- | --- |\n";
  for (const char* pad : {"touch", "plate-5"}) {
    const ChangedScene changed(pad, "machine exact");
    for (const double speed : {5.0, 10.0, 20.0, 40.0}) {
      sim::Workcell cell(changed.scene());
      for (double gone = 0; gone < way;) {
        const double step = std::min(speed * 0.028, way - gone);
        gone = gone + step >= way - 1e-9 ? way : gone + step;
        if (const auto refused = cell.move({0, 0, step, 0, 0, 0}, sim::CorrectionFrame::tool, cell.now()))
          throw std::runtime_error(*refused);
        cell.advance_to(cell.now() + sim::alter_period);
      }
      cell.advance_to(cell.now() + std::chrono::milliseconds(500));
      double peak = 0;
      for (const sim::Sample& sample : cell.log()) peak = std::max(peak, sample.contact_force);
      const double rest = cell.log().back().contact_force;
      out << fmt::format("| {} | {} mm/s | {:.1f} | {:.1f} | {:.1f} |\n", pad, speed, peak, rest,
                         peak - rest);
    }
  }
}

}  // namespace

void write_causes(std::ostream& out) {
  write_press_causes(out);
  write_touch_causes(out);
  write_pushes(out);
}

}  // namespace pal::test
