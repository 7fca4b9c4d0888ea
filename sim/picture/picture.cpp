#include "sim/picture/picture.hpp"

#include <algorithm>
#include <functional>

#include "sim/model/private/physics.hpp"
#include "sim/picture/private/offscreen.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {
namespace {

constexpr int most_shapes = 2000;

// What MuJoCo keeps for drawing, freed in the order that it needs: both while the context is current.
class Drawing {
 public:
  explicit Drawing(const mjModel& model) {
    mjv_defaultScene(&scene);
    mjr_defaultContext(&context);
    mjv_makeScene(&model, &scene, most_shapes);
    mjr_makeContext(&model, &context, mjFONTSCALE_100);
  }
  ~Drawing() {
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  mjvScene scene{};
  mjrContext context{};
};

mjvCamera choose_camera(const mjModel& model, const std::string& name) {
  mjvCamera camera;
  mjv_defaultFreeCamera(&model, &camera);
  const int fixed = mj_name2id(&model, mjOBJ_CAMERA, name.c_str());
  if (fixed >= 0) {
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = fixed;
  }
  return camera;
}

Image draw(Workcell& workcell, const PictureOptions& options) {
  Physics& physics = workcell.physics();
  mjModel& model = physics.model();
  model.vis.global.offwidth = options.width;
  model.vis.global.offheight = options.height;
  Drawing drawing(model);
  mjr_setBuffer(mjFB_OFFSCREEN, &drawing.context);
  if (drawing.context.currentBuffer != mjFB_OFFSCREEN) throw NoOffscreen("OpenGL has no off-screen buffer");

  mjvOption shown;
  mjv_defaultOption(&shown);
  mjvCamera camera = choose_camera(model, options.camera);
  mjv_updateScene(&model, &physics.data(), &shown, nullptr, &camera, mjCAT_ALL, &drawing.scene);
  const mjrRect view{0, 0, options.width, options.height};
  mjr_render(view, &drawing.scene, &drawing.context);

  Image image{options.width, options.height, {}};
  image.pixels.resize(3 * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
  mjr_readPixels(image.pixels.data(), nullptr, view, &drawing.context);
  // OpenGL's first row is the lowest.
  const auto row = static_cast<std::ptrdiff_t>(3 * options.width);
  for (std::ptrdiff_t top = 0, bottom = options.height - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(image.pixels.begin() + top * row, image.pixels.begin() + (top + 1) * row,
                     image.pixels.begin() + bottom * row);
  return image;
}

}  // namespace

Picture take_picture(Workcell& workcell, const PictureOptions& options) {
  struct Way {
    const char* name;
    Renderer renderer;
    std::function<std::unique_ptr<Offscreen>()> open;
  };
  const Way ways[] = {
      {"EGL", Renderer::egl, [] { return open_egl(); }},
      {"OSMesa", Renderer::osmesa, [&] { return open_osmesa(options.width, options.height); }}};
  Picture picture;
  for (const Way& way : ways) {
    if (options.renderer != Renderer::automatic && options.renderer != way.renderer) continue;
    try {
      const std::unique_ptr<Offscreen> context = way.open();
      picture.image = draw(workcell, options);
      picture.renderer = way.name;
      picture.problem.clear();
      return picture;
    } catch (const std::runtime_error& problem) {
      picture.problem +=
          (picture.problem.empty() ? "" : "; ") + std::string(way.name) + ": " + problem.what();
    }
  }
  return picture;
}

}  // namespace pal::sim
