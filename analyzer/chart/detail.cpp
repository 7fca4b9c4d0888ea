#include "analyzer/chart/detail.hpp"

#include <algorithm>
#include <optional>

namespace pal::analyzer::chart {

namespace {

// A bar of this width holds its number.
constexpr Length wanted_bar = 122;
// Below this, a second drawing would show nothing that the first does not.
constexpr Length legible_bar = 100;
// In units of a short action. A bar of up to `most_units` is drawn whole. Of a longer one `end_units` are
// drawn of each end. A stretch has at least `least_units`.
constexpr std::int64_t most_units = 10;
constexpr std::int64_t end_units = 2;
constexpr std::int64_t least_units = 8;

struct Focus {
  std::int64_t from_ns;
  std::int64_t to_ns;
};

std::optional<Focus> highlighted(const std::vector<Layer>& layers) {
  std::optional<Focus> focus;
  for (const Layer& layer : layers) {
    if (!layer.options->highlight) continue;
    const std::int64_t from = layer.options->highlight->from_ns + layer.shift_ns;
    const std::int64_t to = layer.options->highlight->to_ns + layer.shift_ns;
    focus = focus ? Focus{std::min(focus->from_ns, from), std::max(focus->to_ns, to)} : Focus{from, to};
  }
  return focus;
}

std::vector<Window> actions_in(const std::vector<Layer>& layers, const Window& window) {
  std::vector<Window> actions;
  for (const Layer& layer : layers) {
    for (const Lane& lane : layer.timeline->lanes) {
      if (lane.device) continue;
      for (const Bar& bar : lane.bars) {
        const Window action{bar.from_ns + layer.shift_ns, bar.to_ns + layer.shift_ns};
        if (action.to_ns >= window.from_ns && action.from_ns <= window.to_ns) actions.push_back(action);
      }
    }
  }
  std::sort(actions.begin(), actions.end(), [](const Window& a, const Window& b) {
    return a.from_ns != b.from_ns ? a.from_ns < b.from_ns : a.to_ns < b.to_ns;
  });
  return actions;
}

// Of the actions that take time, the length that nine in ten reach.
std::int64_t short_action(const std::vector<Window>& actions) {
  std::vector<std::int64_t> lengths;
  for (const Window& action : actions) {
    if (action.to_ns > action.from_ns) lengths.push_back(action.to_ns - action.from_ns);
  }
  if (lengths.empty()) return 0;
  std::sort(lengths.begin(), lengths.end());
  return lengths[lengths.size() / 10];
}

std::vector<Window> merged(const std::vector<Window>& sorted, std::int64_t pad_ns, std::int64_t gap_ns,
                           const Window& within) {
  std::vector<Window> result;
  for (const Window& it : sorted) {
    // An end of a long action that the window shows the middle of.
    if (it.to_ns < within.from_ns || it.from_ns > within.to_ns) continue;
    const Window padded{std::max(within.from_ns, it.from_ns - pad_ns),
                        std::min(within.to_ns, it.to_ns + pad_ns)};
    if (!result.empty() && padded.from_ns - result.back().to_ns <= gap_ns) {
      result.back().to_ns = std::max(result.back().to_ns, padded.to_ns);
    } else {
      result.push_back(padded);
    }
  }
  return result;
}

std::int64_t distance(const Window& window, std::int64_t instant) {
  if (instant < window.from_ns) return window.from_ns - instant;
  return instant > window.to_ns ? instant - window.to_ns : 0;
}

// Of an action much longer than others only its ends: what is between shows nothing.
std::vector<Window> with_long_ones_split(const std::vector<Window>& actions, std::int64_t unit) {
  std::vector<Window> result;
  for (const Window& action : actions) {
    if (action.to_ns - action.from_ns <= most_units * unit) {
      result.push_back(action);
      continue;
    }
    result.push_back({action.from_ns, action.from_ns + end_units * unit});
    result.push_back({action.to_ns - end_units * unit, action.to_ns});
  }
  std::sort(result.begin(), result.end(),
            [](const Window& a, const Window& b) { return a.from_ns < b.from_ns; });
  return result;
}

/// Which stretches are worth their place, and which part of those that are too long.
class Choice {
 public:
  Choice(const std::vector<Layer>& layers, Focus focus, const std::vector<Window>& actions, std::int64_t unit)
      : focus_(focus), unit_(unit) {
    instants_.push_back({focus.from_ns, weight_of_edge});
    instants_.push_back({focus.to_ns, weight_of_edge});
    const Layer& first = layers.front();
    for (const Segment& segment : first.options->explanation) {
      if (segment.depth == 0) instants_.push_back({segment.from_ns + first.shift_ns, weight_of_part});
    }
    for (const Window& action : actions) instants_.push_back({action.from_ns, 1});
    std::sort(instants_.begin(), instants_.end());
  }

  /// Windows of `room` together, with a fold between two; in order of time.
  std::vector<Window> choose(std::vector<Window> candidates, std::int64_t room, std::int64_t fold) const {
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Window& a, const Window& b) {
      const std::int64_t more = weight(a);
      const std::int64_t less = weight(b);
      return more != less ? more > less : distance(a, focus_.to_ns) < distance(b, focus_.to_ns);
    });
    // As many of the important ones as may have a legible part each, then each as much as is left for it.
    std::size_t important = 0;
    while (important < candidates.size() && weight(candidates[important]) >= weight_of_part &&
           static_cast<std::int64_t>(important + 1) * (least_units * unit_ + fold) <= room) {
      ++important;
    }
    std::stable_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(important),
                     [](const Window& a, const Window& b) { return length(a) < length(b); });
    std::vector<Window> chosen;
    std::int64_t left = room + fold;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const bool needed = i < important;
      const std::int64_t share = (needed ? left / static_cast<std::int64_t>(important - i) : left) - fold;
      if (length(candidates[i]) > share && !needed) continue;
      chosen.push_back(length(candidates[i]) > share ? best_part(candidates[i], share) : candidates[i]);
      left -= length(chosen.back()) + fold;
    }
    std::sort(chosen.begin(), chosen.end(),
              [](const Window& a, const Window& b) { return a.from_ns < b.from_ns; });
    return chosen;
  }

 private:
  struct Instant {
    std::int64_t at_ns;
    std::int64_t weight;
    bool operator<(const Instant& other) const { return at_ns < other.at_ns; }
  };
  static constexpr std::int64_t weight_of_edge = 1'000'000;
  static constexpr std::int64_t weight_of_part = 1'000;

  static std::int64_t length(const Window& window) { return window.to_ns - window.from_ns; }

  std::int64_t weight(const Window& window) const {
    const auto first = std::lower_bound(instants_.begin(), instants_.end(), Instant{window.from_ns, 0});
    std::int64_t sum = 0;
    for (auto it = first; it != instants_.end() && it->at_ns <= window.to_ns; ++it) sum += it->weight;
    return sum;
  }

  /// The part of this length with the most to see; of several the last. It begins a little before something.
  Window best_part(const Window& whole, std::int64_t length) const {
    Window best{whole.to_ns - length, whole.to_ns};
    std::int64_t most = weight(best);
    for (auto it = instants_.rbegin(); it != instants_.rend(); ++it) {
      const std::int64_t from = std::max(whole.from_ns, it->at_ns - unit_);
      if (it->at_ns > whole.to_ns || from + length > whole.to_ns) continue;
      if (it->at_ns < whole.from_ns) break;
      const Window part{from, from + length};
      if (const std::int64_t now = weight(part); now > most) {
        most = now;
        best = part;
      }
    }
    return best;
  }

  Focus focus_;
  std::int64_t unit_;
  std::vector<Instant> instants_;
};

}  // namespace

Window overview_window(const std::vector<Layer>& layers) {
  const Layer& first = layers.front();
  if (first.options->window) {
    return {first.options->window->from_ns + first.shift_ns, first.options->window->to_ns + first.shift_ns};
  }
  std::int64_t run_from = first.shift_ns;
  std::int64_t run_to = first.shift_ns + 1;
  for (const Layer& layer : layers) {
    run_from = std::min(run_from, layer.shift_ns);
    run_to = std::max(run_to, layer.shift_ns + layer.timeline->end_ns);
  }
  const std::optional<Focus> focus = highlighted(layers);
  if (!focus) return {run_from, run_to};
  std::int64_t to = focus->to_ns;
  // A limit that is not reached is worth seeing if it is near.
  for (const Layer& layer : layers) {
    const auto& highlight = layer.options->highlight;
    if (!highlight || highlight->limit_ns < 0) continue;
    const std::int64_t limit = highlight->from_ns + layer.shift_ns + highlight->limit_ns;
    if (limit - focus->to_ns <= (focus->to_ns - focus->from_ns) / 6) to = std::max(to, limit);
  }
  const std::int64_t context = std::max<std::int64_t>((to - focus->from_ns) / 8, 1000);
  Window window{std::max(run_from, focus->from_ns - context), std::min(std::max(run_to, to), to + context)};
  // Not worth a tear.
  if (window.from_ns - run_from <= context / 2) window.from_ns = run_from;
  if (run_to - window.to_ns <= context / 2) window.to_ns = std::max(window.to_ns, run_to);
  return window.to_ns > window.from_ns ? window : Window{window.from_ns, window.from_ns + 1};
}

std::vector<Window> detail_windows(const std::vector<Layer>& layers, const Window& window, Length width,
                                   Length fold) {
  const std::optional<Focus> focus = highlighted(layers);
  if (!focus) return {};
  const std::vector<Window> actions = actions_in(layers, window);
  const std::int64_t unit = short_action(actions);
  if (unit == 0 || unit * width / (window.to_ns - window.from_ns) >= legible_bar) return {};

  const auto time_of = [&](Length length) { return length * unit / wanted_bar; };
  const std::vector<Window> candidates =
      merged(with_long_ones_split(actions, unit), unit, time_of(2 * fold), window);
  return Choice(layers, *focus, actions, unit).choose(candidates, time_of(width), time_of(fold));
}

}  // namespace pal::analyzer::chart
