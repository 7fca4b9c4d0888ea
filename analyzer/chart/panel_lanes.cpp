// The lanes of a chart: bars of threads, processors and devices, and waveforms.
#include <algorithm>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

// What is shorter than this on the page is drawn as wide; its title has the true time.
constexpr Length least_bar = 14;
constexpr Length lane_font = 85;
constexpr Length spot_width = 56;

std::string style_of(const Bar& bar, Role role) {
  std::string style = "bar ";
  switch (bar.kind) {
    case BarKind::computation:
      style += "computation";
      break;
    case BarKind::message:
      style += "message";
      break;
    case BarKind::condition:
      style += "conditional";
      break;
    case BarKind::serving:
      style += "serving";
      break;
  }
  if (role == Role::backdrop) style += " backdrop";
  if (!bar.finished) style += " unfinished";
  return style;
}

// "3\u20137,1,2": numbers that follow each other as a run.
std::string runs(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t first = 0, last = 0; first < numbers.size(); first = last + 1) {
    last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ",";
    text += std::to_string(numbers[first]);
    if (last > first) text += (last > first + 1 ? "\u2013" : ",") + std::to_string(numbers[last]);
  }
  return text;
}

// Then that is written into the bar.
bool is_lost(const Layer& layer, const Lane& lane, const Bar& bar) {
  const auto& losses = layer.options->losses;
  return std::any_of(losses.begin(), losses.end(), [&](const Loss& loss) {
    return loss.lane == lane.name && loss.from_ns == bar.from_ns && loss.to_ns == bar.to_ns;
  });
}

}  // namespace

Box Panel::bar_box(const Layer& layer, std::size_t lane, std::int64_t from_ns, std::int64_t to_ns) const {
  const Row& row = rows_[static_cast<std::size_t>(layer.rows[lane])];
  const Length left = x(layer, from_ns);
  const Length top = layer.role == Role::front ? (row.bar_top + row.bar_bottom) / 2 : row.bar_top;
  return {left, top, std::max(x(layer, to_ns), left + least_bar), row.bar_bottom};
}

std::string Panel::bar_title(const Layer& layer, const Lane& lane, const Bar& bar) const {
  std::string title = lane.name + ": " + bar.text + "\n";
  title += at(bar.from_ns + layer.shift_ns) + " to " + at(bar.to_ns + layer.shift_ns);
  title += " (" + duration_text(bar.to_ns - bar.from_ns) + ")";
  if (bar.resumed) title += ", resumed";
  if (!bar.finished) title += ", not finished";
  if (bar.line > 0) title += "\n" + bar.file + ":" + std::to_string(bar.line);
  return title;
}

void Panel::draw_bars(const Layer& layer) {
  for (std::size_t i = 0; i < layer.timeline->lanes.size(); ++i) {
    if (layer.rows[i] < 0) continue;
    const Lane& lane = layer.timeline->lanes[i];
    for (const Bar& bar : lane.bars) {
      if (!touches(layer, bar.from_ns, bar.to_ns)) continue;
      if (const Crowd* crowd = crowd_at(layer, i, bar.from_ns, bar.to_ns)) {
        if (&bar == &lane.bars[crowd->first]) draw_crowd(layer, i, *crowd);
        continue;
      }
      const Box box = bar_box(layer, i, bar.from_ns, bar.to_ns);
      const auto number = static_cast<std::size_t>(&bar - lane.bars.data());
      out_.rect(box, style_of(bar, layer.role), bar_title(layer, lane, bar),
                layer.options->ids ? "bar-" + std::to_string(i) + "-" + std::to_string(number) : "");
      if (layer.role != Role::backdrop) labels_.take(box);
    }
  }
}

// Above the bars if arrows leave room there, else beside them.
void Panel::label_cluster(const Cluster& cluster, const Row& row) {
  const std::string text = runs(cluster.numbers);
  const Length width = text_width(text, lane_font);
  const Length beside = (row.bar_top + row.bar_bottom) / 2 - 20;
  const Length above = row.bar_top - 25;
  for (const Point at : {Point{(cluster.x0 + cluster.x1 - width) / 2, above}, Point{cluster.x1 + 30, above},
                         Point{cluster.x0 - 30 - width, above}, Point{cluster.x1 + 30, beside},
                         Point{cluster.x0 - 30 - width, beside}}) {
    if (at.x < scale_.x0() || at.x + width > scale_.x1()) continue;
    if (!labels_.claim({at.x - 10, at.y - 75, at.x + width + 10, at.y + 20})) continue;
    out_.text(at, Anchor::start, "number halo", text);
    return;
  }
}

// A text that fits is written into its bar; else its number is; else the numbers of neighbours are written
// together above them.
void Panel::label_bars(const Layer& layer) {
  for (std::size_t i = 0; i < layer.timeline->lanes.size(); ++i) {
    if (layer.rows[i] < 0) continue;
    const Lane& lane = layer.timeline->lanes[i];
    Cluster cluster;
    const Row& row = rows_[static_cast<std::size_t>(layer.rows[i])];
    const auto flush = [&] {
      if (!cluster.numbers.empty()) label_cluster(cluster, row);
      cluster = {};
    };
    for (const Bar& bar : lane.bars) {
      if (!touches(layer, bar.from_ns, bar.to_ns)) continue;
      if (crowd_at(layer, i, bar.from_ns, bar.to_ns) != nullptr) continue;
      const Box box = bar_box(layer, i, bar.from_ns, bar.to_ns);
      const int number = style_.labelled && !bar.resumed ? numbering_.number(lane, bar) : 0;
      if (layer.role == Role::backdrop) {
        if (number != 0) label_backdrop(number, box);
      } else if (text_fits(bar, layer.shift_ns, scale_) && box.y1 - box.y0 >= 100) {
        flush();
        label_wide_bar(layer, lane, bar, box);
      } else if (number != 0 && !label_narrow_bar(layer, lane, bar, box, number)) {
        if (!cluster.numbers.empty() && box.x0 - cluster.x1 > 30) flush();
        if (cluster.numbers.empty()) cluster.x0 = box.x0;
        cluster.x1 = box.x1;
        cluster.numbers.push_back(number);
      }
    }
    flush();
  }
}

// The number of a proved action, in the upper half, where the measured run does not cover it.
void Panel::label_backdrop(int number, const Box& box) {
  const std::string text = std::to_string(number);
  const TimeScale::Stretch room = scale_.widest(box.x0, box.x1);
  const Length half = text_width(text, lane_font) / 2;
  if (2 * half + 10 > room.x1 - room.x0) return;
  const Length middle = (room.x0 + room.x1) / 2;
  const Length baseline = box.y0 + (box.y1 - box.y0) / 4 + 30;
  if (!labels_.claim({middle - half, baseline - 75, middle + half, baseline + 20})) return;
  out_.text({middle, baseline}, Anchor::middle, "number faded", text);
}

bool Panel::label_narrow_bar(const Layer& layer, const Lane& lane, const Bar& bar, const Box& box,
                             int number) {
  const std::string text = std::to_string(number);
  const TimeScale::Stretch room = scale_.widest(box.x0, box.x1);
  if (text_width(text, lane_font) + 10 > room.x1 - room.x0 || box.y1 - box.y0 < 70) return false;
  const std::string ink = bar.kind == BarKind::computation ? "on-dark" : "on-light";
  out_.text({(room.x0 + room.x1) / 2, (box.y0 + box.y1) / 2 + 30}, Anchor::middle, "number " + ink, text,
            bar_title(layer, lane, bar));
  return true;
}

void Panel::label_wide_bar(const Layer& layer, const Lane& lane, const Bar& bar, const Box& box) {
  const TimeScale::Stretch room = scale_.widest(box.x0, box.x1);
  const Length width = text_width(bar.text, bar_font);
  if (width + 40 > room.x1 - room.x0 || is_lost(layer, lane, bar)) return;
  const Length middle = (room.x0 + room.x1) / 2;
  if (bar.kind == BarKind::serving) {
    out_.rect({middle - width / 2 - 20, box.y0 + 20, middle + width / 2 + 20, box.y1 - 20}, "paper");
  }
  const char* ink = bar.kind == BarKind::computation ? "on-dark" : "on-light";
  out_.text({middle, (box.y0 + box.y1) / 2 + 30}, Anchor::middle, ink, bar.text, bar_title(layer, lane, bar));
}

void Panel::draw_waves(const Layer& layer) {
  for (std::size_t i = 0; i < layer.timeline->waveforms.size(); ++i) {
    if (layer.waves[i] < 0) continue;
    const Waveform& wave = layer.timeline->waveforms[i];
    const Row& row = waves_[static_cast<std::size_t>(layer.waves[i])];
    const auto level = [&](bool value) { return value ? row.bar_top : row.bar_bottom; };
    const std::string faded = layer.role == Role::backdrop ? " backdrop" : "";
    bool value = false;
    std::string data;
    for (const Sample& set : wave.sets) {
      if (set.at_ns + layer.shift_ns < scale_.from_ns()) value = set.value;
    }
    const bool first = value;
    data = move_to({scale_.x0(), level(value)});
    for (const Sample& set : wave.sets) {
      const std::int64_t instant = set.at_ns + layer.shift_ns;
      if (set.value == value || instant < scale_.from_ns() || instant > scale_.to_ns()) continue;
      data += line_to({scale_.x(instant), level(value)}) + line_to({scale_.x(instant), level(set.value)});
      value = set.value;
    }
    data += line_to({std::min(scale_.x1(), x(layer, layer.timeline->end_ns)), level(value)});
    out_.path(data, "wave" + faded, "condition " + wave.name);
    if (layer.role != Role::backdrop) {
      out_.text({scale_.x0() - 60, (row.bar_top + row.bar_bottom) / 2 + 30}, Anchor::end, "small",
                first ? "TRUE" : "FALSE");
    }
    const auto who = [&](const Sample& sample) {
      return sample.lane < 0 ? std::string()
                             : " by " + layer.timeline->lanes[static_cast<std::size_t>(sample.lane)].name;
    };
    const auto spot = [&](const Sample& sample, const std::string& style, const std::string& what) {
      if (!touches(layer, sample.at_ns, sample.at_ns)) return;
      const Length place = x(layer, sample.at_ns);
      const Length y = level(sample.value);
      out_.rect({place - 28, y - 28, place + 28, y + 28}, style + faded,
                wave.name + " " + what + (sample.value ? " TRUE" : " FALSE") + who(sample) + "\n" +
                    at(sample.at_ns + layer.shift_ns));
    };
    const auto spots = [&](const std::vector<Sample>& samples, const char* style, const char* what) {
      const Sample* last = nullptr;
      for (const Sample& sample : samples) {
        const bool near = last != nullptr && last->value == sample.value &&
                          x(layer, sample.at_ns) - x(layer, last->at_ns) < spot_width;
        if (near && has_crowds(layer) && !is_edge(layer, sample.at_ns)) continue;
        spot(sample, style, what);
        last = &sample;
      }
    };
    spots(wave.sets, "set", "set to");
    spots(wave.reads, "read", "read as");
  }
}

}  // namespace pal::analyzer::chart
