#include "programs/pal/studies/progress.hpp"

#include <cmath>
#include <ostream>

namespace pal::program {

std::string about(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  constexpr long long minute = 60, hour = 3600;
  if (whole < minute) return std::to_string(whole) + " s";
  if (whole < hour) return std::to_string(whole / minute) + " min " + std::to_string(whole % minute) + " s";
  return std::to_string(whole / hour) + " h " + std::to_string(whole % hour / minute) + " min";
}

Progress::~Progress() {
  if (any_) console_.err << "\r\x1b[K" << std::flush;
}

void Progress::show(std::size_t done) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  if (!console_.terminal || now - shown_ < 200ms) return;
  shown_ = now;
  any_ = true;
  console_.err << "\r\x1b[K" << done << " of " << all_ << " proofs";
  if (done > 0) {
    const double spent = std::chrono::duration<double>(now - begin_).count();
    console_.err << ", about " << about(spent / static_cast<double>(done) * static_cast<double>(all_ - done))
                 << " left";
  }
  console_.err << "; Ctrl-C stops, and what is done is kept" << std::flush;
}

}  // namespace pal::program
