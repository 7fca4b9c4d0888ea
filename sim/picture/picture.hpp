// Pictures of the workcell without a screen.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

struct PictureOptions {
  int width = 1280;
  int height = 960;
  Renderer renderer = Renderer::automatic;
  /// A camera of the scene. Where the scene has none of this name, MuJoCo's free camera is used.
  std::string camera = "report";
};

/// Either an image or the reason why there is none: pictures are never worth a crash.
struct Picture {
  std::optional<Image> image;
  std::string problem;   // what was tried and why it failed; empty with an image
  std::string renderer;  // who drew it: "EGL" or "OSMesa"
};

/// Draws the workcell as it stands. Takes 10 to 1000 ms, so not while a run is going on.
Picture take_picture(Workcell& workcell, const PictureOptions& options = {});

/// The image as the bytes of a PNG file. Throws std::runtime_error if libpng cannot.
std::string encode_png(const Image& image);

}  // namespace pal::sim
