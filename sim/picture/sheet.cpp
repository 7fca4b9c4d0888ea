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

void plot_force(Canvas& canvas, const Box& box, const ForceHistory& force, double now,
                const std::optional<double>& threshold, double size) {
  const double top = round_up(std::max({force.peak(), threshold.value_or(0), 1.0}));
  const double end = std::max(now, 0.1);
  const double left = box.x + 3.2 * size, right = box.x + box.width - size;
  const double high = box.y + size, low = box.y + box.height - 1.6 * size;
  const auto across = [&](double t) { return left + (right - left) * t / end; };
  const auto up = [&](double newtons) { return low - (low - high) * newtons / top; };
  for (const double part : {0.0, 0.5, 1.0}) {
    canvas.line({{left, up(part * top)}, {right, up(part * top)}}, rule, 1);
    canvas.text(left - 0.4 * size, up(part * top) + 0.35 * size, fmt::format("{:g}", part * top), size, faint,
                false, Canvas::Align::right);
  }
  canvas.text(left, low + 1.3 * size, "0 s", size, faint);
  canvas.text(right, low + 1.3 * size, fmt::format("{:.2f} s", end), size, faint, false,
              Canvas::Align::right);
  if (threshold)
    canvas.line({{left, up(*threshold)}, {right, up(*threshold)}}, limit, std::max(1.0, size / 12));
  std::vector<std::pair<double, double>> points;
  for (const auto& [t, newtons] : force.points()) points.emplace_back(across(t), up(newtons));
  canvas.line(points, curve, std::max(1.2, size / 8));
}

}  // namespace

void ForceHistory::add(const ForcePoint& point) {
  constexpr std::size_t most = 4096;
  // Of every second pair the higher one stays: peaks are what matters.
  if (points_.size() == most) {
    for (std::size_t i = 0; i < most / 2; ++i)
      points_[i] = points_[2 * i].second > points_[2 * i + 1].second ? points_[2 * i] : points_[2 * i + 1];
    points_.resize(most / 2);
  }
  points_.push_back(point);
  peak_ = std::max(peak_, point.second);
}

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
  for (const ForcePoint& point : snapshot.force) force_.add(point);
  stage_.show(snapshot);
  if (!camera_) camera_.emplace(stage_, static_cast<double>(main_width_) / options_.height, options_.camera);
  if (!contact_camera_) contact_camera_.emplace(stage_);

  const Focus whole{stage_.base() + Eigen::Vector3d(0, 0, 0.1), 1.4};
  Canvas canvas(options_.width, options_.height);
  canvas.place(painter_.paint(stage_, camera_->view(stage_, calm), whole, main_width_, options_.height), 0,
               0);
  const View near = contact_camera_->view(stage_, calm);
  canvas.place(painter_.paint(stage_, near, {stage_.tip(), 0.25}, side_, side_), main_width_, 0);
  const Box inset{static_cast<double>(main_width_), 0, static_cast<double>(side_),
                  static_cast<double>(side_)};
  scale_bar(canvas, inset, near);
  const Box panel{inset.x, inset.height, inset.width, static_cast<double>(options_.height) - inset.height};
  canvas.fill(panel, paper);
  describe(canvas, panel, snapshot.sample);
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

void Sheet::describe(Canvas& canvas, const Box& box, const Sample& sample) const {
  const double size = options_.height / 38.0, left = box.x + size, width = box.width - 2 * size;
  const double middle = left + 0.33 * width;
  double y = box.y + 1.7 * size;
  canvas.text_within(width, left, y, options_.title, 1.1 * size, ink, true);
  const auto row = [&](const std::string& name, const std::string& value) {
    y += 1.55 * size;
    canvas.text(left, y, name, size, faint);
    canvas.text_within(left + width - middle, middle, y, value, size, ink);
  };
  const Eigen::Vector3d tool = sample.tool * 1e3;
  row("time", fmt::format("{:.3f} s", sheet_seconds(sample.time)));
  row("force", fmt::format("{:.1f} N    (peak {:.1f} N)", sample.contact_force, force_.peak()));
  row("tool", fmt::format("{:.1f}  {:.1f}  {:.1f} mm", tool.x(), tool.y(), tool.z()));
  y += 1.6 * size;
  canvas.text(left, y, options_.threshold ? "contact force, N; red: threshold" : "contact force, N",
              0.8 * size, faint);
  plot_force(canvas, {box.x, y, box.width, box.y + box.height - y}, force_, sheet_seconds(sample.time),
             options_.threshold, 0.75 * size);
}

}  // namespace pal::sim
