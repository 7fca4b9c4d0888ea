// Processor time of pictures, drawn without a graphics card.
#include <fmt/format.h>

#include "sim/picture/sheet.hpp"
#include "sim/workcell.hpp"
#include "tests/benchmark/workcell/clock.hpp"
#include "tests/benchmark/workcell/row.hpp"

namespace pal::bench {
namespace {

/// Milliseconds of all threads, mean of some; the first, which prepares, does not count.
template <class Draw>
double milliseconds(const Draw& draw) {
  constexpr int count = 20;
  draw();
  const double begin = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  for (int i = 0; i < count; ++i) draw();
  return (cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - begin) / count * 1e3;
}

}  // namespace

std::vector<Row> picture_rows() {
  sim::Workcell workcell(sim::find_scene("touch", {PAL_SCENE_DIR}));
  const sim::Snapshot snapshot = sim::take_snapshot(workcell, {});
  double plain = 0, frame = 0;
  {
    sim::Stage stage(workcell.physics().model());
    stage.show(snapshot);
    sim::Painter painter(stage, {.width = 640, .height = 480, .quality = sim::Quality::quick});
    sim::WorkcellCamera camera(stage, 4.0 / 3, "");
    plain = milliseconds([&] { painter.paint(stage, camera.view(stage, 0), {stage.base(), 1.4}, 640, 480); });
  }
  {
    sim::Sheet sheet(workcell.physics().model(),
                     {.width = 960, .height = 540, .quality = sim::Quality::quick});
    frame = milliseconds([&] { sheet.draw(snapshot, 0.9); });
  }
  return {{"CPU of a picture, 640 x 480, without shadows", fmt::format("{:.1f} ms", plain), "at most 40 ms",
           plain <= 40},
          {"CPU of a frame of a video, 960 x 540, unencoded", fmt::format("{:.1f} ms", frame), "", true}};
}

}  // namespace pal::bench
