// The picture that a person sees: the workcell, the contact close up, and what there is to say about both.
// Private to pal_sim.
#pragma once

#include <string>
#include <vector>

#include "sim/picture/camera.hpp"
#include "sim/picture/canvas.hpp"
#include "sim/picture/laser.hpp"
#include "sim/picture/painter.hpp"

namespace pal::sim {

/// Lays out pictures of one size, one after the other. Lives on one thread, as its painter does.
class Sheet {
 public:
  /// Throws NoOffscreen.
  Sheet(const mjModel& model, const PictureOptions& options);

  /// `calm`: see WorkcellCamera.
  Image draw(const Snapshot& snapshot, double calm);
  const std::string& renderer() const { return painter_.name(); }

 private:
  void describe(Canvas& canvas, const Box& box, const Snapshot& snapshot) const;
  void plot_range(Canvas& canvas, const Box& box, double now) const;
  void scale_bar(Canvas& canvas, const Box& box, const View& view) const;

  PictureOptions options_;
  int main_width_, side_;  // of the workcell's picture; of the close-up, which is square
  Stage stage_;
  Painter painter_;
  PeakHistory history_;
  Laser laser_;  // of the picture that is drawn; empty without a range finder
  std::optional<WorkcellCamera> camera_;
  std::optional<ContactCamera> contact_camera_;
};

}  // namespace pal::sim
