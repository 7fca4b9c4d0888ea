#include "sim/picture/painter.hpp"

#include <algorithm>
#include <array>

namespace pal::sim {
namespace {

constexpr int most_shapes = 2000;
constexpr int shadow_map = 2048;

mjvCamera camera_of(const View& view) {
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  if (view.fixed >= 0) {
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = view.fixed;
    return camera;
  }
  camera.type = mjCAMERA_FREE;
  std::copy_n(view.target.data(), 3, camera.lookat);
  camera.distance = view.distance;
  camera.azimuth = view.azimuth;
  camera.elevation = view.elevation;
  return camera;
}

// A directional light has no place, but MuJoCo draws its shadows around one: the focus gets all of the shadow
// map.
void aim_lights(Stage& stage, const Focus& focus) {
  constexpr double away = 3;  // m: nothing that casts a shadow is behind the light
  for (int light = 0; light < stage.model().nlight; ++light) {
    if (!stage.model().light_directional[light]) continue;
    Eigen::Map<Eigen::Vector3d> position(stage.data().light_xpos + 3 * light);
    const Eigen::Map<const Eigen::Vector3d> direction(stage.data().light_xdir + 3 * light);
    position = focus.centre - away * direction;
  }
}

void add(mjvScene& scene, const Mark& mark) {
  if (scene.ngeom == scene.maxgeom) return;
  mjvGeom* const shape = scene.geoms + scene.ngeom++;
  const std::array<float, 4> colour{
      static_cast<float>(mark.colour.red), static_cast<float>(mark.colour.green),
      static_cast<float>(mark.colour.blue), static_cast<float>(mark.colour.opacity)};
  const std::array<mjtNum, 3> size{mark.radius, mark.radius, mark.radius};
  const bool ball = mark.from == mark.to;
  mjv_initGeom(shape, ball ? mjGEOM_SPHERE : mjGEOM_CAPSULE, size.data(), mark.from.data(), nullptr,
               colour.data());
  if (!ball)
    mjv_makeConnector(shape, mjGEOM_CAPSULE, mark.radius, mark.from.x(), mark.from.y(), mark.from.z(),
                      mark.to.x(), mark.to.y(), mark.to.z());
  shape->category = mjCAT_DECOR;
  shape->emission = 1;  // bright in the shadow, too
}

}  // namespace

// What MuJoCo keeps for drawing, freed in the order that it needs: both while the context is current.
class Painter::Drawing {
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

Painter::Painter(Stage& stage, const PainterOptions& options) {
  std::string problems, packages;
  for (const Renderer way : {Renderer::egl, Renderer::osmesa}) {
    if (options.renderer != Renderer::automatic && options.renderer != way) continue;
    name_ = way == Renderer::egl ? "EGL" : "OSMesa";
    try {
      open(stage, options, way);
      return;
    } catch (const std::runtime_error& problem) {
      drawing_.reset();
      context_.reset();
      problems += (problems.empty() ? "" : "; ") + name_ + ": " + problem.what();
      const auto* const missing = dynamic_cast<const NoOffscreen*>(&problem);
      if (missing != nullptr && packages.empty()) packages = missing->packages();
    }
  }
  throw NoOffscreen(problems, packages);
}

Painter::~Painter() = default;

void Painter::open(Stage& stage, const PainterOptions& options, Renderer way) {
  context_ = way == Renderer::egl ? open_egl() : open_osmesa(options.width, options.height);
  mjModel& model = stage.model();
  model.vis.global.offwidth = options.width;
  model.vis.global.offheight = options.height;
  const bool fine = options.quality == Quality::fine;
  model.vis.quality.offsamples = fine ? 8 : 4;
  model.vis.quality.shadowsize = fine ? shadow_map : 0;
  // Without a graphics card corners cost as much as pixels do.
  model.vis.quality.numslices = fine ? 64 : 20;
  model.vis.quality.numstacks = fine ? 32 : 10;
  drawing_ = std::make_unique<Drawing>(model);
  drawing_->scene.flags[mjRND_REFLECTION] = fine;
  mjr_setBuffer(mjFB_OFFSCREEN, &drawing_->context);
  if (drawing_->context.currentBuffer != mjFB_OFFSCREEN) throw NoOffscreen("OpenGL has no off-screen buffer");
}

Image Painter::paint(Stage& stage, const View& view, const Focus& focus, int width, int height,
                     const std::vector<Mark>& marks) {
  mjModel& model = stage.model();
  model.vis.global.fovy = static_cast<float>(view.opening);
  // Depth is what the near plane is worth: as far away as the close-up allows.
  model.vis.map.znear = static_cast<float>(std::min(view.distance, 1.0) / 4 / model.stat.extent);

  mjvOption shown;
  mjv_defaultOption(&shown);
  mjvCamera camera = camera_of(view);
  aim_lights(stage, focus);
  drawing_->context.shadowClip = static_cast<float>(focus.radius);
  mjv_updateScene(&model, &stage.data(), &shown, nullptr, &camera, mjCAT_ALL, &drawing_->scene);
  for (const Mark& mark : marks) add(drawing_->scene, mark);
  const mjrRect place{0, 0, width, height};
  mjr_render(place, &drawing_->scene, &drawing_->context);

  Image image{width, height, {}};
  image.pixels.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  mjr_readPixels(image.pixels.data(), nullptr, place, &drawing_->context);
  // OpenGL's first row is the lowest.
  const auto row = static_cast<std::ptrdiff_t>(3 * width);
  for (std::ptrdiff_t top = 0, bottom = height - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(image.pixels.begin() + top * row, image.pixels.begin() + (top + 1) * row,
                     image.pixels.begin() + bottom * row);
  return image;
}

}  // namespace pal::sim
