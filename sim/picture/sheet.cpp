#include "sim/picture/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pal::sim {
namespace {

constexpr Colour paper{0.98, 0.98, 0.97};
constexpr Colour ink{0.13, 0.15, 0.18};
constexpr Colour faint{0.45, 0.48, 0.52};
constexpr Colour rule{0.80, 0.82, 0.84};
constexpr Colour curve{0.10, 0.34, 0.64};
constexpr Colour limit{0.78, 0.25, 0.10};

constexpr double sheet_seconds(runtime::Time time) {
  return std::chrono::duration<double>(time).count();
}

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power) return step * power;
  return 10 * power;
}

struct Axes {
  double left, right, high, low;  // pixels
};

Axes axes_in(const Box& box, double size) {
  return {box.x + 3.2 * size, box.x + box.width - size, box.y + size, box.y + box.height - 1.6 * size};
}

/// Three lines across with their figures, from `least` to `greatest`.
void rule_lines(Canvas& canvas, const Axes& axes, double least, double greatest, double size) {
  for (const double part : {0.0, 0.5, 1.0}) {
    const double y = axes.low - part * (axes.low - axes.high);
    canvas.line({{axes.left, y}, {axes.right, y}}, rule, 1);
    canvas.text(axes.left - 0.4 * size, y + 0.35 * size,
                fmt::format("{:g}", least + part * (greatest - least)), size, faint, false,
                Canvas::Align::right);
  }
}

void plot_history(Canvas& canvas, const Box& box, const PeakHistory& history, double now,
                  const std::optional<double>& threshold, double size) {
  const double top = round_up(std::max({history.peak(), threshold.value_or(0), 1.0}));
  const double end = std::max(now, 0.1);
  const Axes axes = axes_in(box, size);
  const auto across = [&](double t) { return axes.left + (axes.right - axes.left) * std::min(t / end, 1.0); };
  const auto up = [&](double value) { return axes.low - (axes.low - axes.high) * value / top; };
  rule_lines(canvas, axes, 0, top, size);
  canvas.text(axes.left, axes.low + 1.3 * size, "0 s", size, faint);
  canvas.text(axes.right, axes.low + 1.3 * size, fmt::format("{:.2f} s", end), size, faint, false,
              Canvas::Align::right);
  if (threshold)
    canvas.line({{axes.left, up(*threshold)}, {axes.right, up(*threshold)}}, limit, std::max(1.0, size / 12));
  std::vector<std::pair<double, double>> points;
  for (const auto& [t, value] : history.points()) points.emplace_back(across(t), up(value));
  canvas.line(points, curve, std::max(1.2, size / 8));
}

/// What the fan meets, seen along the fan's axis, the sensor above.
void plot_profile(Canvas& canvas, const Box& box, const Laser& laser, double size) {
  const Axes axes = axes_in(box, size);
  double least = 1e300, greatest = -1e300, side = 10;
  for (const Laser::Point& point : laser.points) {
    least = std::min(least, point.away);
    greatest = std::max(greatest, point.away);
    side = std::max(side, std::abs(point.across));
  }
  if (laser.points.empty()) {
    canvas.text((axes.left + axes.right) / 2, (axes.high + axes.low) / 2, "nothing in reach", size, faint,
                false, Canvas::Align::centre);
    return;
  }
  const double step = round_up(std::max(greatest - least, 8.0) / 2);
  const double top = std::floor(least / step) * step;
  const double bottom = std::max(top + 2 * step, std::ceil(greatest / step) * step);
  // The sensor looks down: what is farther away is lower.
  rule_lines(canvas, axes, bottom, top, size);
  std::vector<std::pair<double, double>> line;
  const auto draw = [&] {
    if (line.size() > 1) canvas.line(line, limit, std::max(1.2, size / 8));
    line.clear();
  };
  for (std::size_t i = 0; i < laser.points.size(); ++i) {
    const Laser::Point& point = laser.points[i];
    constexpr double one_surface = 12;  // mm
    if (i > 0 && std::abs(point.away - laser.points[i - 1].away) > one_surface) draw();
    line.emplace_back((axes.left + axes.right) / 2 + point.across / side * (axes.right - axes.left) / 2,
                      axes.high + (point.away - top) / (bottom - top) * (axes.low - axes.high));
  }
  draw();
  canvas.text(axes.left, axes.low + 1.3 * size, fmt::format("{:.0f} mm", -side), size, faint);
  canvas.text(axes.right, axes.low + 1.3 * size, fmt::format("{:.0f} mm", side), size, faint, false,
              Canvas::Align::right);
}

/// A ring of three balls would hide what is hit; one that can be seen through does not.
std::vector<Mark> marks_of_hit(const Eigen::Vector3d& place) {
  return {{place, place, 0.006, {0.95, 0.10, 0.05, 1}}, {place, place, 0.022, {0.95, 0.10, 0.05, 0.30}}};
}

}  // namespace

Sheet::Sheet(const mjModel& model, const PictureOptions& options)
    : options_(options),
      main_width_(options.width - options.height * 5 / 9),
      side_(options.height * 5 / 9),
      stage_(model),
      painter_(stage_, {.renderer = options.renderer,
                        .width = std::max(main_width_, side_),
                        .height = options.height,
                        .quality = options.quality}) {}

Image Sheet::draw(const Snapshot& snapshot, double calm) {
  for (const HistoryPoint& point : snapshot.history) history_.add(point);
  stage_.show(snapshot);
  std::vector<Mark> marks;
  if (stage_.tool() == ToolKind::range_finder) {
    laser_ = laser_of(stage_);
    marks = marks_of(laser_, stage_);
    // A picture alone is given the distances that were measured.
    if (const auto nearest = laser_.nearest(); nearest && options_.history.empty())
      history_.add({sheet_seconds(snapshot.sample.time), *nearest});
  }
  const auto hit = snapshot.hit ? std::optional(stage_.in_world(*snapshot.hit)) : std::nullopt;
  if (hit)
    for (const Mark& mark : marks_of_hit(*hit)) marks.push_back(mark);
  if (!camera_) camera_.emplace(stage_, static_cast<double>(main_width_) / options_.height, options_.camera);
  if (!contact_camera_) contact_camera_.emplace(stage_);

  const Focus whole{stage_.base() + Eigen::Vector3d(0, 0, 0.1), 1.4};
  Canvas canvas(options_.width, options_.height);
  canvas.place(
      painter_.paint(stage_, camera_->view(stage_, calm), whole, main_width_, options_.height, marks), 0, 0);
  const View near = hit ? contact_camera_->view_of_place(stage_, *hit) : contact_camera_->view(stage_, calm);
  canvas.place(painter_.paint(stage_, near, {hit.value_or(stage_.tip()), 0.25}, side_, side_, marks),
               main_width_, 0);
  const Box inset{static_cast<double>(main_width_), 0, static_cast<double>(side_),
                  static_cast<double>(side_)};
  scale_bar(canvas, inset, near);
  const Box panel{inset.x, inset.height, inset.width, static_cast<double>(options_.height) - inset.height};
  canvas.fill(panel, paper);
  describe(canvas, panel, snapshot);
  const double line = std::max(1.0, options_.height / 300.0);
  canvas.line({{inset.x, 0}, {inset.x, static_cast<double>(options_.height)}}, ink, line);
  canvas.line({{inset.x, panel.y}, {inset.x + inset.width, panel.y}}, ink, line);
  return canvas.image();
}

void Sheet::scale_bar(Canvas& canvas, const Box& box, const View& view) const {
  const double across = 2 * view.distance * std::tan(view.opening * mjPI / 360);
  const double metre = box.height / across, length = round_up(0.13 * across);
  const double size = options_.height / 45.0, x = box.x + size, y = box.y + box.height - size;
  canvas.fill({x - 0.5 * size, y - 1.9 * size, length * metre + size, 2.4 * size}, {1, 1, 1, 0.72});
  canvas.line({{x, y - 0.4 * size}, {x, y}, {x + length * metre, y}, {x + length * metre, y - 0.4 * size}},
              ink, std::max(1.0, size / 8));
  canvas.text(x + length * metre / 2, y - 0.6 * size, fmt::format("{:g} mm", length * 1e3), size, ink, false,
              Canvas::Align::centre);
}

void Sheet::describe(Canvas& canvas, const Box& box, const Snapshot& snapshot) const {
  const Sample& sample = snapshot.sample;
  const double size = options_.height / 38.0, left = box.x + size, width = box.width - 2 * size;
  const double middle = left + 0.33 * width, now = sheet_seconds(sample.time);
  double y = box.y + 1.7 * size;
  canvas.text_within(width, left, y, options_.title, 1.1 * size, ink, true);
  const auto row = [&](const std::string& name, const std::string& value, const Colour& colour = ink) {
    y += 1.55 * size;
    canvas.text(left, y, name, size, faint);
    canvas.text_within(left + width - middle, middle, y, value, size, colour);
  };
  const Eigen::Vector3d tool = sample.tool * 1e3;
  row("time", fmt::format("{:.3f} s", now));
  if (stage_.tool() == ToolKind::range_finder) {
    const auto nearest = laser_.nearest();
    row("distance", nearest ? fmt::format("{:.1f} mm to the nearest point", *nearest) : "nothing in reach");
  } else if (stage_.tool() == ToolKind::gripper) {
    row("grip",
        fmt::format("{:.1f} N    ({})", sample.grip_force,
                    sample.contact_force > 0 ? fmt::format("a finger meets {:.1f} N", sample.contact_force)
                                             : fmt::format("fingers {:.1f} mm apart", sample.gripper_width)));
  } else {
    row("force", fmt::format("{:.1f} N    (peak {:.1f} N)", sample.contact_force, history_.peak()));
  }
  if (snapshot.fault.empty())
    row("tool", fmt::format("{:.1f}  {:.1f}  {:.1f} mm", tool.x(), tool.y(), tool.z()));
  else
    row("stopped", snapshot.fault.substr(0, snapshot.fault.find(';')), limit);
  y += 1.6 * size;
  const Box rest{box.x, y, box.width, box.y + box.height - y};
  if (stage_.tool() == ToolKind::range_finder) {
    canvas.text(left, y, "profile, mm", 0.8 * size, faint);
    canvas.text(box.x + box.width / 2 + size, y, "distance, mm", 0.8 * size, faint);
    return plot_range(canvas, rest, now);
  }
  const std::string what = stage_.tool() == ToolKind::gripper ? "grip of each finger, N" : "contact force, N";
  canvas.text(left, y, what + (options_.threshold ? "; red: " + options_.threshold_name : ""), 0.8 * size,
              faint);
  plot_history(canvas, rest, history_, now, options_.threshold, 0.75 * size);
}

void Sheet::plot_range(Canvas& canvas, const Box& box, double now) const {
  const double size = 0.75 * options_.height / 38.0, half = box.width / 2;
  plot_profile(canvas, {box.x, box.y, half, box.height}, laser_, size);
  plot_history(canvas, {box.x + half, box.y, half, box.height}, history_, now, std::nullopt, size);
}

}  // namespace pal::sim
