// The picture that a person sees: the workcell, the contact close up, and what there is to say about both.
// Private to pal_sim.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/picture/camera.hpp"
#include "sim/picture/canvas.hpp"
#include "sim/picture/painter.hpp"

namespace pal::sim {

/// Force against time, as much of it as a strip of a picture can show.
class ForceHistory {
 public:
  void add(const ForcePoint& point);
  const std::vector<ForcePoint>& points() const { return points_; }
  double peak() const { return peak_; }

 private:
  std::vector<ForcePoint> points_;
  double peak_ = 0;
};

/// Lays out pictures of one size, one after the other. Lives on one thread, as its painter does.
class Sheet {
 public:
  /// Throws NoOffscreen.
  Sheet(const mjModel& model, const PictureOptions& options);

  /// `calm`: see WorkcellCamera.
  Image draw(const Snapshot& snapshot, double calm);
  const std::string& renderer() const { return painter_.name(); }

 private:
  void describe(Canvas& canvas, const Box& box, const Sample& sample) const;
  void scale_bar(Canvas& canvas, const Box& box, const View& view) const;

  PictureOptions options_;
  int main_width_, side_;  // of the workcell's picture; of the close-up, which is square
  Stage stage_;
  Painter painter_;
  ForceHistory force_;
  std::optional<WorkcellCamera> camera_;
  std::optional<ContactCamera> contact_camera_;
};

}  // namespace pal::sim
