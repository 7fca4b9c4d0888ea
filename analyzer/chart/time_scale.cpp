#include "analyzer/chart/time_scale.hpp"

#include <algorithm>

namespace pal::analyzer::chart {

namespace {

constexpr Length least_tick_distance = 620;

/// a * b / c, where the product of a time and a length may be more than a number of 64 bits.
std::int64_t share(std::int64_t a, std::int64_t b, std::int64_t c) {
  __extension__ using Wide = __int128;
  return static_cast<std::int64_t>(static_cast<Wide>(a) * b / c);
}

/// floor(a / b) for b > 0.
std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

struct Step {
  std::int64_t ns;
  std::int64_t minor_ns;
};

Step step_for(const TimeScale& scale) {
  for (std::int64_t power = 1;; power *= 10) {
    for (const std::int64_t factor : {1, 2, 5}) {
      const std::int64_t step = power * factor;
      if (scale.width(step) >= least_tick_distance)
        return {step, std::max<std::int64_t>(1, step / (factor == 2 ? 4 : 5))};
    }
  }
}

struct Unit {
  const char* name;
  std::int64_t ns;
};

Unit unit_for(std::int64_t step_ns) {
  if (step_ns >= 1'000'000'000) return {"s", 1'000'000'000};
  if (step_ns >= 10'000) return {"ms", 1'000'000};
  if (step_ns >= 10) return {"\u00b5s", 1'000};
  return {"ns", 1};
}

std::string label(std::int64_t ns, std::int64_t step_ns, std::int64_t unit_ns) {
  if (ns < 0) return "\u2212" + label(-ns, step_ns, unit_ns);
  std::string text = std::to_string(ns / unit_ns);
  std::string decimals;
  for (std::int64_t rest = ns % unit_ns, digit = unit_ns / 10, left = step_ns % unit_ns; left != 0;
       digit /= 10) {
    decimals += static_cast<char>('0' + rest / digit);
    rest %= digit;
    left %= digit;
  }
  return decimals.empty() ? text : text + "." + decimals;
}

/// In a stretch too short for the step: its roundest instant, with as many decimals as that needs.
Tick roundest(const Window& time, std::int64_t step_ns, std::int64_t zero_ns, std::int64_t unit_ns) {
  std::int64_t power = 1;
  while (power < step_ns) power *= 10;
  for (; power > 1; power /= 10) {
    for (const std::int64_t part : {1, 2, 5}) {
      const std::int64_t step = power / part;
      const std::int64_t at = floor_div(time.to_ns - zero_ns, step) * step + zero_ns;
      if (step * part == power && at >= time.from_ns) return {at, label(at - zero_ns, step, unit_ns)};
    }
  }
  return {time.from_ns, label(time.from_ns - zero_ns, 1, unit_ns)};
}

}  // namespace

TimeScale::TimeScale(const std::vector<Window>& windows, Length x0, Length x1, Length fold) {
  for (const Window& window : windows) total_ns_ += window.to_ns - window.from_ns;
  total_ns_ = std::max<std::int64_t>(total_ns_, 1);
  total_width_ = x1 - x0 - fold * (static_cast<Length>(windows.size()) - 1);
  std::int64_t shown = 0;
  Length folds = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (i > 0) {
      const Length before = pieces_.back().x1;
      pieces_.push_back({{windows[i - 1].to_ns, windows[i].from_ns}, before, before + fold, true});
      folds += fold;
    }
    const Length begin = x0 + folds + width(shown);
    shown += windows[i].to_ns - windows[i].from_ns;
    pieces_.push_back({windows[i], begin, x0 + folds + width(shown), false});
  }
}

Length TimeScale::width(std::int64_t ns) const {
  return share(ns, total_width_, total_ns_);
}

Length TimeScale::x(std::int64_t ns) const {
  if (ns <= from_ns()) return x0();
  for (const Piece& piece : pieces_) {
    const std::int64_t length = piece.time.to_ns - piece.time.from_ns;
    if (ns <= piece.time.to_ns)
      return piece.x0 +
             share(ns - piece.time.from_ns, piece.x1 - piece.x0, std::max<std::int64_t>(length, 1));
  }
  return x1();
}

TimeScale::Stretch TimeScale::widest(Length left, Length right) const {
  Stretch best{left, left};
  for (const Piece& piece : pieces_) {
    const Stretch part{std::max(left, piece.x0), std::min(right, piece.x1)};
    if (!piece.folded && part.x1 - part.x0 > best.x1 - best.x0) best = part;
  }
  return best;
}

bool TimeScale::shows(std::int64_t ns) const {
  return touches(ns, ns);
}

bool TimeScale::touches(std::int64_t from_ns, std::int64_t to_ns) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return !piece.folded && to_ns >= piece.time.from_ns && from_ns <= piece.time.to_ns;
  });
}

Ticks ticks(const TimeScale& scale, std::int64_t zero_ns) {
  const Step step = step_for(scale);
  const Unit unit = unit_for(step.ns);
  Ticks result;
  result.unit = unit.name;
  for (const TimeScale::Piece& piece : scale.pieces()) {
    if (piece.folded) continue;
    const auto first = [&](std::int64_t step_ns) {
      return -floor_div(-(piece.time.from_ns - zero_ns), step_ns) * step_ns + zero_ns;
    };
    const std::size_t before = result.major.size();
    for (std::int64_t at = first(step.ns); at <= piece.time.to_ns; at += step.ns) {
      result.major.push_back({at, label(at - zero_ns, step.ns, unit.ns)});
    }
    if (result.major.size() == before)
      result.major.push_back(roundest(piece.time, step.ns, zero_ns, unit.ns));
    for (std::int64_t at = first(step.minor_ns); at <= piece.time.to_ns; at += step.minor_ns)
      result.minor.push_back(at);
  }
  return result;
}

}  // namespace pal::analyzer::chart
