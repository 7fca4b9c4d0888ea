// The shapes that a scene may have.
#include <fmt/format.h>

#include <cmath>

#include "sim/model/mjcf.hpp"

namespace pal::sim {
namespace {

constexpr double shoulder = 671.8;     // mm above the floor
constexpr double spring_mass = 0.4;    // kg, of a surface on a spring
constexpr double gravity = 9.81;       // m/s^2
constexpr double steel_damping = 0.7;  // of a steel plate's spring, of what is critical
constexpr double sponge_damping = 3.0;
constexpr double pedestal_width = 40;  // mm

// Metres from the floor.
std::string position(double x, double y, double z) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", x / 1e3, y / 1e3, z / 1e3);
}

std::string box(double x, double y, double z, double lx, double ly, double lz, std::string_view material,
                std::string_view more = {}) {
  return fmt::format(
      "<geom class=\"cell\" type=\"box\" pos=\"{}\" size=\"{:.9g} {:.9g} {:.9g}\" material=\"{}\" {}/>",
      position(x, y, z), lx / 2e3, ly / 2e3, lz / 2e3, material, more);
}

std::string cylinder(double z, double diameter, double length, std::string_view material,
                     std::string_view more = {}) {
  return fmt::format(
      "<geom class=\"cell\" type=\"cylinder\" pos=\"{}\" size=\"{:.9g} {:.9g}\" material=\"{}\" {}/>",
      position(0, 0, z), diameter / 2e3, length / 2e3, material, more);
}

constexpr std::string_view no_contact = "contype=\"0\" conaffinity=\"0\"";

class ShapeMaker {
 public:
  ShapeMaker(const Thing& thing, bool table, std::string file, std::vector<Heights>& heights)
      : thing_(thing), table_(table), file_(std::move(file)), heights_(heights) {}

  Shape make() {
    if (thing_.kind == "plate") plate();
    if (thing_.kind == "sponge") sponge();
    if (thing_.kind == "waves") field(wave_heights(thing_), "plate");
    if (thing_.kind == "surface") surface();
    if (thing_.kind == "block") block();
    if (thing_.kind == "bar") bar();
    if (thing_.kind == "post") post();
    if (thing_.kind == "pyramid") pyramid();
    if (thing_.kind == "pallet") pallet();
    if (thing_.kind == "part") part();
    return std::move(shape_);
  }

 private:
  double at(std::size_t i) const { return thing_.all("at")[i]; }
  double size(std::size_t i) const { return thing_.all("size")[i]; }

  // A body whose frame is `above` the middle of the thing's underside.
  void body(double above, const std::string& inside, bool turned = true) {
    const double turn = turned ? radians(thing_.one("turn")) : 0;
    shape_.body += fmt::format("<body name=\"{}\" pos=\"{}\" euler=\"0 0 {:.12g}\">{}</body>\n", thing_.name,
                               position(at(0), at(1), at(2) + above + shoulder), turn, inside);
  }

  // What a fixed thing in mid-air stands on. `solid`: the arm can hit it.
  std::string pedestal(double under, double width, bool solid) const {
    const double ground = table_ ? table_top : -shoulder;
    const double height = at(2) - ground;
    if (height < 1) return {};
    return cylinder(under - height / 2, width, height, "graphite", solid ? std::string_view{} : no_contact);
  }

  void plate() {
    const std::vector<double>& tilt = thing_.all("tilt");
    const std::string slab =
        fmt::format("<body euler=\"{:.12g} {:.12g} 0\">{}{}</body>", radians(tilt[0]), radians(tilt[1]),
                    spring(thing_.one("stiffness"), steel_damping, tilt),
                    box(0, 0, -size(2) / 2, size(0), size(1), size(2), "plate"));
    const bool solid = thing_.one("stiffness") == 0;
    // Below a tilted plate the pedestal ends at the plate's middle plane, so that it does not come through.
    body(size(2), slab + pedestal(-size(2), pedestal_width, solid));
  }

  void sponge() {
    body(size(2), fmt::format("<body>{}{}</body>", spring(thing_.one("stiffness"), sponge_damping, {0, 0}),
                              box(0, 0, -size(2) / 2, size(0), size(1), size(2), "sponge")) +
                      pedestal(-size(2), pedestal_width, false));
  }

  // Holds the surface up against its weight and gives way along its normal.
  static std::string spring(double stiffness, double damping_ratio, const std::vector<double>& tilt) {
    if (stiffness == 0) return {};
    const double k = stiffness * 1e3;
    const double weight = spring_mass * gravity * std::cos(radians(tilt[0])) * std::cos(radians(tilt[1]));
    return fmt::format(
        "<joint type=\"slide\" axis=\"0 0 1\" stiffness=\"{:.9g}\" damping=\"{:.9g}\" springref=\"{:.9g}\"/>"
        "<inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"2e-3 2e-3 4e-3\"/>",
        k, 2 * damping_ratio * std::sqrt(k * spring_mass), weight / k, spring_mass);
  }

  // How thick the field is below its least height.
  double base_of(const Heights& heights) const {
    const double base = size(2) - heights.span;
    if (base < 1)
      throw SceneError(file_ + ":" + std::to_string(thing_.line),
                       fmt::format("the surface is {:.1f} mm deep, more than its height of {:g} mm allows",
                                   heights.span, size(2)),
                       "write a greater third figure after size, or less height and slope");
    return base;
  }

  // The shape of a height field, which is kept for after loading.
  std::string field_geom(Heights heights, std::string_view material, std::string_view more) {
    shape_.assets +=
        fmt::format("<hfield name=\"{}\" nrow=\"{}\" ncol=\"{}\" size=\"{:.9g} {:.9g} {:.9g} {:.9g}\"/>\n",
                    heights.name, heights.rows, heights.columns, size(0) / 2e3, size(1) / 2e3,
                    heights.span / 1e3, base_of(heights) / 1e3);
    heights_.push_back(std::move(heights));
    return fmt::format("<geom class=\"cell\" type=\"hfield\" hfield=\"{}\" material=\"{}\" {}/>",
                       heights_.back().name, material, more);
  }

  void field(Heights heights, std::string_view material) {
    const double base = base_of(heights);
    body(base, field_geom(std::move(heights), material, {}) + pedestal(-base, pedestal_width, true));
  }

  // The range finder sees a fine field, the tool meets a coarse one.
  void surface() {
    Heights fine = surface_heights(thing_);
    const double base = base_of(fine);
    // In a body of its own: MuJoCo takes a height field for a body's mass only where it is alone.
    const std::string felt = "<body>" + field_geom(coarser(fine), "aluminium", "group=\"3\"") + "</body>";
    const std::string line = seam(fine);
    body(base, felt + line + field_geom(std::move(fine), "aluminium", no_contact) +
                   pedestal(-base, pedestal_width, true));
  }

  // A dark line for pictures: no ray meets it, and the tool does not feel it. Group 1 is what rays pass.
  std::string seam(const Heights& fine) const {
    std::string line;
    const auto points = seam_of(thing_, fine);
    for (std::size_t i = 1; i < points.size(); ++i)
      line += fmt::format(
          "<geom type=\"capsule\" fromto=\"{} {}\" size=\"0.0007\" group=\"1\" "
          "material=\"graphite\" "
          "{}/>",
          position(points[i - 1][0], points[i - 1][1], points[i - 1][2]),
          position(points[i][0], points[i][1], points[i][2]), no_contact);
    return "<body>" + line + "</body>";
  }

  void block() {
    body(0, box(0, 0, size(2) / 2, size(0), size(1), size(2), "steel") + pedestal(0, pedestal_width, true));
  }

  void bar() {
    const double length = thing_.one("length"), diameter = thing_.one("diameter");
    std::string inside = fmt::format(
        "<geom class=\"cell\" type=\"cylinder\" pos=\"{}\" euler=\"0 1.5707963267948966 0\" size=\"{:.9g} "
        "{:.9g}\" material=\"warning\"/>",
        position(0, 0, diameter / 2), diameter / 2e3, length / 2e3);
    const double height = at(2) + diameter / 2 + shoulder;  // its stands go down to the floor
    for (const double side : {-1.0, 1.0})
      if (height > 1)
        inside += box(side * (length - diameter) / 2, 0, diameter / 2 - height / 2, diameter, diameter,
                      height, "graphite");
    body(0, inside);
  }

  void post() {
    const double height = thing_.one("height");
    body(0, cylinder(height / 2, thing_.one("diameter"), height, "warning"), false);
  }

  void pyramid() {
    const auto steps = static_cast<int>(thing_.one("steps"));
    std::string inside = pedestal(0, pedestal_width, true);
    for (int i = 0; i < steps; ++i) {
      const double part = 1.0 - static_cast<double>(i) / steps;
      const double rise = size(2) / steps;
      inside += box(0, 0, (i + 0.5) * rise, part * size(0), part * size(1), rise, "aluminium");
    }
    body(0, inside);
  }

  void pallet() {
    constexpr double floor = 6, rib = 5, rib_height = 6;  // mm
    const double pitch = thing_.one("pitch");
    const auto rows = static_cast<int>(thing_.one("rows")), columns = static_cast<int>(thing_.one("columns"));
    const double lx = columns * pitch + rib, ly = rows * pitch + rib;
    std::string inside = pedestal(0, pedestal_width, true) + box(0, 0, floor / 2, lx, ly, floor, "tray");
    for (int i = 0; i <= columns; ++i)
      inside += box((i - columns / 2.0) * pitch, 0, floor + rib_height / 2, rib, ly, rib_height, "tray");
    for (int i = 0; i <= rows; ++i)
      inside += box(0, (i - rows / 2.0) * pitch, floor + rib_height / 2, lx, rib, rib_height, "tray");
    body(0, inside);
  }

  void part() {
    // Grasps hold with these contacts (docs/workcell/model.md); a part meets the arm, the cell and other
    // parts.
    body(size(2) / 2,
         fmt::format(
             "<freejoint/><geom type=\"box\" size=\"{:.9g} {:.9g} {:.9g}\" mass=\"{:.9g}\" "
             "contype=\"3\" conaffinity=\"3\" condim=\"4\" friction=\"0.8 0.005 0.0001\" solref=\"0.005 1\" "
             "solimp=\"0.95 0.99 0.001\" material=\"part\"/>",
             size(0) / 2e3, size(1) / 2e3, size(2) / 2e3, thing_.one("mass") / 1e3));
  }

  const Thing& thing_;
  bool table_;
  std::string file_;
  std::vector<Heights>& heights_;
  Shape shape_;
};

}  // namespace

Shape shape_of(const Thing& thing, bool table, const std::string& file, std::vector<Heights>& heights) {
  return ShapeMaker(thing, table, file, heights).make();
}

std::string thing_materials() {
  return R"(<material name="sponge" rgba="0.93 0.78 0.30 1" specular="0.05" shininess="0.05"/>
    <material name="aluminium" rgba="0.80 0.82 0.84 1" specular="0.5" shininess="0.4"/>
    <material name="part" rgba="0.16 0.42 0.70 1" specular="0.4" shininess="0.4"/>
    <material name="tray" rgba="0.36 0.40 0.38 1" specular="0.2" shininess="0.2"/>
    <material name="warning" rgba="0.95 0.72 0.05 1" specular="0.4" shininess="0.4"/>
)";
}

}  // namespace pal::sim
