#include "sim/picture/picture.hpp"

#include "sim/picture/sheet.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

Picture take_picture(Workcell& workcell, const PictureOptions& options) {
  Picture picture;
  try {
    std::size_t logged = 0;
    Sheet sheet(workcell.physics().model(), options);
    picture.image = sheet.draw(take_snapshot(workcell, logged), 0);
    picture.renderer = sheet.renderer();
  } catch (const std::runtime_error& problem) {
    picture.problem = problem.what();
  }
  return picture;
}

}  // namespace pal::sim
