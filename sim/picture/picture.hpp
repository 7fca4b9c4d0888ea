// Pictures of the workcell without a screen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/picture/peak_history.hpp"

namespace pal::sim {

class Workcell;

/// 8 bits each of red, green and blue; rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<unsigned char> pixels;
};

enum class Renderer {
  automatic,  // EGL, and OSMesa where that fails
  egl,        // EGL on Mesa's surfaceless platform
  osmesa,
};

enum class Quality {
  fine,   // shadows, reflections, smooth edges: half a second
  quick,  // none of them: some 30 ms, for videos
};

struct PictureOptions {
  int width = 1600;
  int height = 900;
  Renderer renderer = Renderer::automatic;
  Quality quality = Quality::fine;
  /// A camera of the scene. If the scene has none of this name, the camera is placed by itself. Arm, tool and
  /// workpiece are then in the picture, and nothing hides the tool.
  std::string camera = "report";
  /// Above the figures, for instance "touch in scene touch".
  std::string title{};
  /// N: drawn into the curve of the force, and what it is called.
  std::optional<double> threshold{};
  std::string threshold_name = "threshold";
  /// What the curve shows up to now: the force, or the distance if the tool is the range finder.
  std::vector<HistoryPoint> history{};
};

/// An image, or the reason why there is none; a missing picture must not end a run.
struct Picture {
  std::optional<Image> image;
  std::string problem;   // what was tried and why it failed; empty with an image
  std::string packages;  // Debian's, that are not installed and would draw it; empty: nothing is missing
  std::string renderer;  // what drew it: "EGL" or "OSMesa"
};

/// Draws the workcell as it stands: the whole, and beside it a close-up of the contact, or of the place where
/// the arm has hit something. Adds time, force and place of the tool, and the force over the run. Of a range
/// finder there are its fan, its profile and the distance in place of the force. Takes 50 to 1000 ms, so not
/// while a run is going on. The physics are not touched.
Picture take_picture(Workcell& workcell, const PictureOptions& options = {});

/// The image as the bytes of a PNG file. Throws std::runtime_error if libpng cannot.
std::string encode_png(const Image& image);

}  // namespace pal::sim
