#include "sim/devices/range_finder_emulator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace pal::sim {
namespace {

using runtime::Time;
namespace protocol = runtime::drivers::range_finder;

constexpr std::size_t longest_range_line = 40;
constexpr std::size_t point_length = 13;  // with the line's end
constexpr std::size_t end_length = 10;
constexpr int most_requests = 99;
constexpr double degree = std::numbers::pi / 180;
constexpr Time step = std::chrono::milliseconds(1);

// The mirror's swing grows to its full width: by this much less at first, and less and less in this time.
constexpr double missing_swing = 0.3;
constexpr double swing_time = 8e-3;  // s

double scan_seconds(Time time) {
  return static_cast<double>(time.count()) * 1e-9;
}

}  // namespace

double range_error(double z) {
  struct Known {
    double z, error;
  };
  static constexpr std::array<Known, 4> known{{{150, 0.1}, {250, 0.2}, {850, 2}, {1000, 20}}};
  if (z <= known.front().z) return known.front().error;
  const auto above =
      std::find_if(known.begin() + 1, known.end() - 1, [z](const Known& k) { return k.z >= z; });
  const Known& a = *(above - 1);
  const double part = (z - a.z) / (above->z - a.z);
  return a.error * std::pow(above->error / a.error, part);
}

RangeFinderEmulator::RangeFinderEmulator(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link,
                                         RangeView view, RangeFinderEmulatorOptions options)
    : timeline_(timeline),
      link_(link),
      view_(std::move(view)),
      options_(options),
      phase_(options.seed, 4),
      noise_(options.seed, 5) {
  link_.connect(this);
}

RangeFinderEmulator::~RangeFinderEmulator() {
  timeline_.cancel(next_scan_);
  timeline_.cancel(next_step_);
  link_.connect(nullptr);
}

void RangeFinderEmulator::on_bytes(runtime::drivers::Bytes bytes) {
  for (const std::uint8_t byte : bytes) {
    if (byte == '\r') {
      obey(std::exchange(line_, {}));
    } else if (byte != '\n' && line_.size() < longest_range_line) {
      line_ += static_cast<char>(byte);
    }
  }
}

void RangeFinderEmulator::obey(const std::string& line) {
  if (line == "INIT") return start();
  if (line == "PROFILE" && swinging_) {
    asked_ = std::min(asked_ + 1, most_requests);
    return;
  }
  send("? " + line + "\r\n");
}

void RangeFinderEmulator::start() {
  timeline_.cancel(next_scan_);
  timeline_.cancel(next_step_);
  swinging_ = false;
  asked_ = 0;
  started_ = timeline_.now();
  const Time phase = options_.phase ? *options_.phase : phase_.between(Time(0), protocol::period - Time(1));
  next_scan_ = timeline_.after(options_.start + phase, [this] { swing(); });
}

void RangeFinderEmulator::swing() {
  swinging_ = true;
  swinging_since_ = timeline_.now();
  // The first line's end closes what the start may have cut off.
  send("\r\n");
  std::array<char, 40> text{};
  const Time now = timeline_.now() + protocol::line.duration(2);
  std::snprintf(text.data(), text.size(), "READY 255 %010lld\r\n", static_cast<long long>(clock(now)));
  send(text.data());
  begin_scan();
}

void RangeFinderEmulator::begin_scan() {
  scan_began_ = timeline_.now();
  next_scan_ = timeline_.after(protocol::period, [this] { begin_scan(); });
  // A request counts from when it was sent, so that one sent before the scan began is in time.
  next_step_ = timeline_.after(protocol::line.duration(std::string_view("PROFILE\r").size()),
                               [this] { take_requests(); });
}

void RangeFinderEmulator::take_requests() {
  if (asked_ == 0) return;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "PROFILE %02d %010lld", std::exchange(asked_, 0),
                static_cast<long long>(clock(scan_began_)));
  sum_ = {};
  sum_.add(text.data());
  send(text.data() + std::string("\r\n"));
  next_point_ = 0;
  before_.reset();
  steep_before_ = false;
  next_step_ = timeline_.at(scan_began_ + step, [this] { scan_step(); });
}

// The points of the last millisecond, from where the arm is now.
void RangeFinderEmulator::scan_step() {
  const Time passed = timeline_.now() - scan_began_;
  text_.clear();
  const Pose pose = view_.pose();
  while (next_point_ < protocol::points && protocol::point_time(next_point_) <= passed) cast_point(pose);
  if (next_point_ < protocol::points) {
    send(text_);
    next_step_ = timeline_.at(scan_began_ + std::min(passed + step, last_step()), [this] { scan_step(); });
    return;
  }
  std::array<char, 16> end{};
  std::snprintf(end.data(), end.size(), "END %04x\r\n", sum_.value());
  send(text_ + end.data());
}

// So that the profile has come 76 ms after the scan began.
Time RangeFinderEmulator::last_step() const {
  std::size_t left = 0;
  while (left < protocol::points &&
         protocol::point_time(protocol::points - 1 - left) > protocol::collecting - step) {
    ++left;
  }
  return protocol::collecting - protocol::line.duration(left * point_length + end_length);
}

void RangeFinderEmulator::cast_point(const Pose& pose) {
  const std::size_t i = next_point_++;
  const Time since = scan_began_ + protocol::point_time(i) - swinging_since_;
  const double swing = 1 - missing_swing * std::exp(-scan_seconds(since) / swing_time);
  const std::optional<Point> met = meet(pose, angle(i) * swing);
  const bool steep = met && before_ && too_steep(*before_, *met);
  // A single leap to a nearer point is the edge of a nearer surface, which this point lies on.
  const bool onto_nearer = steep && !steep_before_ && met->z < before_->z;
  const bool valid =
      met && met->z >= options_.nearest && met->z <= options_.farthest && (!steep || onto_nearer);
  before_ = met;
  steep_before_ = steep;
  std::string line = "----- -----";
  if (valid) line = measured({met->z * std::tan(angle(i)), met->z});
  sum_.add(line);
  text_ += line + "\r\n";
}

double RangeFinderEmulator::angle(std::size_t point) const {
  const double part = static_cast<double>(point) / static_cast<double>(protocol::points - 1);
  return (part - 0.5) * options_.field_of_view * degree;
}

std::optional<RangeFinderEmulator::Point> RangeFinderEmulator::meet(const Pose& pose, double angle) const {
  const Eigen::Vector3d ray(0, std::sin(angle), std::cos(angle));
  const std::optional<double> distance = view_.cast(pose.translation(), pose.linear() * ray);
  if (!distance) return std::nullopt;
  return Point{*distance * ray.y() * 1000, *distance * ray.z() * 1000};
}

// Seen between two neighbouring points; so is a step, which sends the beam's halves back from two distances.
bool RangeFinderEmulator::too_steep(const Point& before, const Point& here) const {
  const double dy = here.y - before.y;
  const double dz = here.z - before.z;
  const double along = (dy * here.y + dz * here.z) / std::hypot(here.y, here.z);
  const double length = std::hypot(dy, dz);
  return std::abs(along) > length * std::sin(options_.steepest * degree);
}

// The angle is known, so that an error of z is one of x, too.
std::string RangeFinderEmulator::measured(const Point& point) {
  const double limit = options_.error_scale * range_error(point.z);
  const double error = std::clamp(limit / 2 * noise_.normal(), -limit, limit);
  const double z = point.z + error;
  const double y = point.y * z / point.z;
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%05ld %05ld", std::lround(y * 10) + protocol::x_offset,
                std::lround(z * 10));
  return text.data();
}

std::int64_t RangeFinderEmulator::clock(Time instant) const {
  return (instant - started_).count() / 1000;
}

void RangeFinderEmulator::send(std::string_view text) {
  if (!text.empty()) link_.write(runtime::drivers::as_bytes(text));
}

}  // namespace pal::sim
