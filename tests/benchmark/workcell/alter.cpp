// Whether ALTER's requests are answered, hour after hour.
#include <fmt/format.h>

#include "sim/cell/cell.hpp"
#include "tests/benchmark/workcell/row.hpp"
#include "tests/support/built_skills.hpp"

namespace pal::bench {

/// After a skill the driver answers with no motion. One request that is not answered stops the arm and closes
/// the port. So it is enough that the port is open at the end.
std::vector<Row> alter_rows() {
  constexpr int cycles = 100'000;
  sim::CellOptions options;
  options.keep_log = false;
  sim::Cell cell(sim::find_scene("nothing", {PAL_SCENE_DIR}), options);
  const auto touch = test::make_skill("touch");
  cell.run(*touch);
  cell.station().idle(cycles * sim::alter_period);
  bool open = false;
  cell.val_driver().submit(
      {.verb = runtime::drivers::val::Verb::open_alter, .location = {}, .second = {}, .figures = {1}},
      [&](const runtime::drivers::val::Answer& answer) {
        open = !answer.ok && answer.error == runtime::drivers::val::Error::busy;
      });
  cell.station().idle(std::chrono::seconds(2));
  return {
      {fmt::format("{} ALTER cycles with physics, all answered", cycles), open ? "yes" : "no", "yes", open}};
}

}  // namespace pal::bench
