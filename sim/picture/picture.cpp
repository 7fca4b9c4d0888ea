#include "sim/picture/picture.hpp"

#include "sim/picture/sheet.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

Picture take_picture(Workcell& workcell, const PictureOptions& options) {
  Picture picture;
  try {
    std::vector<HistoryPoint> history = options.history;
    if (history.empty() && workcell.tool_kind() != ToolKind::range_finder)
      for (const Sample& sample : workcell.log())
        history.emplace_back(std::chrono::duration<double>(sample.time).count(),
                             shown_force(workcell.tool_kind(), sample));
    Sheet sheet(workcell.physics().model(), options);
    picture.image = sheet.draw(take_snapshot(workcell, std::move(history)), 0);
    picture.renderer = sheet.renderer();
  } catch (const NoOffscreen& problem) {
    picture.problem = problem.what();
    picture.packages = problem.packages();
  } catch (const std::runtime_error& problem) {
    picture.problem = problem.what();
  }
  return picture;
}

}  // namespace pal::sim
