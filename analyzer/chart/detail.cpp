#include "analyzer/chart/detail.hpp"

#include <algorithm>
#include <optional>

namespace pal::chart {

namespace {

// A bar of this width holds its number.
constexpr Length wanted_bar = 122;
// Below this, a second drawing would show nothing that the first does not.
constexpr Length legible_bar = 100;

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

// Whether one part of the explanation passes into the next within the window.
bool explains(const Window& window, const Layer& layer, std::int64_t pad_ns) {
  return std::any_of(
      layer.options->explanation.begin(), layer.options->explanation.end(),
      [&](const Segment& segment) { return distance(window, segment.from_ns + layer.shift_ns) <= pad_ns; });
}

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
    if (limit - focus->from_ns <= 2 * (focus->to_ns - focus->from_ns)) to = std::max(to, limit);
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
  const std::vector<Window> candidates = merged(actions, unit, time_of(2 * fold), window);
  std::vector<Window> ranked = candidates;
  const auto rank = [&](const Window& it) {
    if (distance(it, focus->to_ns) <= unit) return std::int64_t{-2};
    if (distance(it, focus->from_ns) <= unit) return std::int64_t{-1};
    if (explains(it, layers.front(), unit)) return std::int64_t{0};
    return distance(it, focus->to_ns);
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&](const Window& a, const Window& b) { return rank(a) < rank(b); });
  std::vector<Window> chosen;
  std::int64_t left = time_of(width);
  for (Window it : ranked) {
    const bool needed = rank(it) < 0;
    const std::int64_t cost = chosen.empty() ? 0 : time_of(fold);
    if (it.to_ns - it.from_ns > left - cost) {
      if (!needed || left - cost < 4 * unit) continue;
      // Too long even alone: what leads to the end, or follows the beginning.
      if (rank(it) == -2) {
        it.to_ns = std::min(it.to_ns, focus->to_ns + 2 * unit);
        it.from_ns = std::max(it.from_ns, it.to_ns - (left - cost));
      } else {
        it.from_ns = std::max(it.from_ns, focus->from_ns - 2 * unit);
        it.to_ns = std::min(it.to_ns, it.from_ns + (left - cost));
      }
    }
    left -= it.to_ns - it.from_ns + cost;
    chosen.push_back(it);
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const Window& a, const Window& b) { return a.from_ns < b.from_ns; });
  return chosen;
}

}  // namespace pal::chart
