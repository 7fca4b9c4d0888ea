#include "programs/workcell/session/progress.hpp"

#include <fmt/format.h>

#include <ostream>

namespace pal::workcell {
namespace {

const char* state(const sim::Workcell& workcell, double force) {
  if (force > 0) return workcell.idle() ? "pressing" : "in contact";
  return workcell.idle() ? "standing" : "moving";
}

}  // namespace

std::string progress_line(const sim::Workcell& workcell, double factor) {
  const double force = workcell.log().empty() ? 0 : workcell.log().back().contact_force;
  const Eigen::Vector3d tool = workcell.tool().translation() * 1e3;
  return fmt::format("{:8.2f} s {:6.1f} x  {:<10}  force {:5.1f} N  tool {:7.1f} {:7.1f} {:7.1f} mm",
                     std::chrono::duration<double>(workcell.log_time()).count(), factor,
                     state(workcell, force), force, tool.x(), tool.y(), tool.z());
}

Progress::Progress(const sim::Workcell& workcell, std::ostream& out, bool terminal, Clock clock)
    : workcell_(workcell),
      out_(out),
      terminal_(terminal),
      clock_(std::move(clock)),
      begin_(clock_()),
      printed_(begin_) {}

void Progress::show() {
  if (terminal_) {
    if (clock_() - printed_ < std::chrono::milliseconds(100)) return;
  } else {
    if (workcell_.log_time() + sim::physics_step <= next_) return;  // the physics go by whole milliseconds
    next_ += std::chrono::seconds(1);
  }
  print();
}

void Progress::end() {
  print();
  if (terminal_) out_ << '\n' << std::flush;
}

void Progress::print() {
  printed_ = clock_();
  const double real = std::max(std::chrono::duration<double>(printed_ - begin_).count(), 1e-6);
  const std::string line =
      progress_line(workcell_, std::chrono::duration<double>(workcell_.log_time()).count() / real);
  // Erase what a longer line may have left.
  if (terminal_)
    out_ << '\r' << line << "\x1b[K";
  else
    out_ << line << '\n';
  out_ << std::flush;
}

}  // namespace pal::workcell
