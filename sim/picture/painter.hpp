// MuJoCo's drawing of a stage, without a screen. Private to pal_sim.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/picture/canvas.hpp"
#include "sim/picture/framing.hpp"
#include "sim/picture/offscreen.hpp"
#include "sim/picture/picture.hpp"
#include "sim/picture/stage.hpp"

namespace pal::sim {

struct PainterOptions {
  Renderer renderer = Renderer::automatic;
  int width = 640, height = 480;  // of the largest picture
  Quality quality = Quality::fine;
};

/// The region in which shadows must be sharp.
struct Focus {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 1;  // m
};

/// Something in the world that only pictures show: a line with round ends, or a ball.
struct Mark {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  // m; the same: a ball
  double radius = 0.001;                                                         // m
  Colour colour{};
};

/// For one thread only, from construction to destruction.
class Painter {
 public:
  /// Throws NoOffscreen with everything that was tried, and with the packages of the first that is missing.
  Painter(Stage& stage, const PainterOptions& options);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// Contract: not larger than the options said.
  Image paint(Stage& stage, const View& view, const Focus& focus, int width, int height,
              const std::vector<Mark>& marks = {});
  /// What draws: "EGL" or "OSMesa".
  const std::string& name() const { return name_; }

 private:
  class Drawing;
  void open(Stage& stage, const PainterOptions& options, Renderer way);

  std::unique_ptr<Offscreen> context_;  // outlives the drawing
  std::unique_ptr<Drawing> drawing_;
  std::string name_;
};

}  // namespace pal::sim
