// A timeline as text, for golden tests.
#include <limits>

#include "analyzer/chart/timeline.hpp"

namespace pal::analyzer::chart {

namespace {

const char* word(BarKind kind) {
  switch (kind) {
    case BarKind::computation:
      return "computes";
    case BarKind::message:
      return "message";
    case BarKind::condition:
      return "condition";
    case BarKind::serving:
      return "serves";
  }
  return "";
}

const char* word(Fate fate) {
  switch (fate) {
    case Fate::taken:
      return "";
    case Fate::dropped:
      return ", dropped";
    case Fate::undelivered:
      return ", undelivered";
  }
  return "";
}

const char* word(MarkKind kind) {
  switch (kind) {
    case MarkKind::event:
      return "event";
    case MarkKind::overrun:
      return "overrun";
    case MarkKind::gave_up:
      return "gave up";
    case MarkKind::cancelled:
      return "cancelled";
    case MarkKind::completion:
      return "completion";
    case MarkKind::fault:
      return "fault";
    case MarkKind::broken:
      return "broken promise";
  }
  return "";
}

class Dumper {
 public:
  Dumper(const Timeline& timeline, std::int64_t from_ns, std::int64_t to_ns)
      : timeline_(timeline), from_ns_(from_ns), to_ns_(to_ns) {}

  std::string dump() {
    line("timeline of " + timeline_.skill + " in " + timeline_.environment + ", " + timeline_.origin +
         ", ends at " + std::to_string(timeline_.end_ns));
    for (const Lane& lane : timeline_.lanes) dump(lane);
    for (const Waveform& wave : timeline_.waveforms) dump(wave);
    line("arrows");
    for (const Arrow& arrow : timeline_.arrows) {
      if (!seen(arrow.from_ns, arrow.to_ns)) continue;
      line("  " + span(arrow.from_ns, arrow.to_ns) + arrow.message + ": " +
           lane(static_cast<std::int64_t>(arrow.from_lane)) + " to " + lane(arrow.to_lane) +
           word(arrow.fate));
    }
    line("marks");
    for (const Mark& mark : timeline_.marks) {
      if (!seen(mark.at_ns, mark.at_ns)) continue;
      line("  " + std::to_string(mark.at_ns) + " " + word(mark.kind) + " at " + lane(mark.lane) + ": " +
           mark.text);
    }
    return std::move(text_);
  }

 private:
  void line(const std::string& text) { text_ += text + "\n"; }
  bool seen(std::int64_t from, std::int64_t to) const { return to >= from_ns_ && from <= to_ns_; }
  static std::string span(std::int64_t from, std::int64_t to) {
    return std::to_string(from) + " " + std::to_string(to) + " ";
  }
  std::string lane(std::int64_t index) const {
    return index < 0 ? std::string("no lane") : timeline_.lanes[static_cast<std::size_t>(index)].name;
  }

  // Bars and gaps of a lane in order of time, as the eye meets them.
  void dump(const Lane& lane) {
    line("lane " + lane.name +
         (lane.device ? ", device"
                      : ", processor " + lane.processor + ", priority " + std::to_string(lane.priority)));
    std::size_t gap = 0;
    const auto gaps_before = [&](std::int64_t instant) {
      for (; gap < lane.gaps.size() && lane.gaps[gap].from_ns < instant; ++gap) dump(lane.gaps[gap]);
    };
    for (const Bar& bar : lane.bars) {
      gaps_before(bar.from_ns);
      if (!seen(bar.from_ns, bar.to_ns)) continue;
      line("  " + span(bar.from_ns, bar.to_ns) + word(bar.kind) + " " + bar.text +
           (bar.resumed ? ", resumed" : "") + (bar.finished ? "" : ", unfinished"));
    }
    gaps_before(std::numeric_limits<std::int64_t>::max());
  }

  void dump(const Gap& gap) {
    if (!seen(gap.from_ns, gap.to_ns)) return;
    line("  " + span(gap.from_ns, gap.to_ns) + (gap.kind == GapKind::ready ? "ready for " : "waits for ") +
         gap.text + (gap.gave_up ? ", in vain" : ""));
  }

  void dump(const Waveform& wave) {
    line("condition " + wave.name);
    dump(wave.sets, "set by");
    dump(wave.reads, "read by");
  }

  void dump(const std::vector<Sample>& samples, const std::string& what) {
    for (const Sample& sample : samples) {
      if (!seen(sample.at_ns, sample.at_ns)) continue;
      line("  " + std::to_string(sample.at_ns) + " " + (sample.value ? "TRUE " : "FALSE ") + what + " " +
           lane(sample.lane));
    }
  }

  const Timeline& timeline_;
  std::int64_t from_ns_;
  std::int64_t to_ns_;
  std::string text_;
};

}  // namespace

std::string dump(const Timeline& timeline, std::int64_t from_ns, std::int64_t to_ns) {
  return Dumper(timeline, from_ns, to_ns).dump();
}

std::string dump(const Timeline& timeline) {
  return dump(timeline, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
}

}  // namespace pal::analyzer::chart
