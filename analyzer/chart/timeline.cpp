#include "analyzer/chart/timeline.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "analyzer/chart/lane_order.hpp"
#include "pal/trace/slices.hpp"

namespace pal::analyzer::chart {

namespace {

using trace::Ending;
using trace::Event;
using trace::Kind;
using trace::Slice;
using trace::State;
using trace::Trace;

BarKind kind_of(std::string_view text) {
  const std::string_view first = text.substr(0, text.find_first_of("( "));
  if (first == "WTM" || first == "TXM") return BarKind::message;
  if (first == "SPC" || first == "RPC" || first == "CASE" || first == "UNTIL") return BarKind::condition;
  return BarKind::computation;
}

class Builder {
 public:
  explicit Builder(const Trace& trace) : trace_(trace) {}

  Timeline build() {
    timeline_.skill = trace_.skill;
    timeline_.environment = trace_.environment;
    timeline_.origin = trace_.origin;
    if (!trace_.events.empty()) timeline_.end_ns = trace_.events.back().time_ns;
    for (const trace::Actor& actor : trace_.actors) {
      timeline_.lanes.push_back({actor.name, actor.device, actor.processor, actor.priority, {}, {}});
    }
    for (const std::string& condition : trace_.conditions) timeline_.waveforms.push_back({condition, {}, {}});
    for (const Slice& slice : trace::slices(trace_)) add_slice(slice);
    for (const Event& event : trace_.events) add_event(event);
    for (auto& [key, arrow] : under_way_) {
      arrow.to_ns = arrow.taken_ns = timeline_.end_ns;
      arrow.fate = Fate::undelivered;
      timeline_.arrows.push_back(arrow);
    }
    name_what_devices_serve();
    // A condition that the run has nothing to do with has no waveform.
    std::erase_if(timeline_.waveforms,
                  [](const Waveform& wave) { return wave.sets.empty() && wave.reads.empty(); });
    put_in_order();
    return std::move(timeline_);
  }

 private:
  Lane& lane(std::int32_t actor) { return timeline_.lanes[static_cast<std::size_t>(actor)]; }

  const trace::Statement* statement(std::int32_t index) const {
    return index < 0 ? nullptr : &trace_.statements[static_cast<std::size_t>(index)];
  }

  void add_slice(const Slice& slice) {
    const trace::Statement* row = statement(slice.statement);
    if (slice.state == State::waiting || slice.state == State::ready) {
      Gap gap{slice.from_ns, slice.to_ns, GapKind::ready, row != nullptr ? row->text : "", false};
      if (slice.state == State::waiting) {
        gap.kind = GapKind::waiting;
        gap.gave_up = slice.ending == Ending::gave_up;
        gap.text = what_is_waited_for(slice, row);
      }
      lane(slice.actor).gaps.push_back(gap);
      return;
    }
    Bar bar{slice.from_ns, slice.to_ns, BarKind::serving, "busy", "", "", 0, false, true};
    if (slice.state == State::running) {
      bar.kind = kind_of(row != nullptr ? row->text : "");
      bar.finished = slice.ending == Ending::effect;
      if (row != nullptr) {
        bar.text = row->text;
        bar.module = row->module;
        bar.file = row->file;
        bar.line = row->line;
      }
      bool& broken = broken_off_[{slice.actor, slice.statement}];
      bar.resumed = broken;
      broken = slice.ending == Ending::preempted;
    } else {
      bar.finished = slice.ending == Ending::over;
    }
    lane(slice.actor).bars.push_back(bar);
  }

  std::string what_is_waited_for(const Slice& slice, const trace::Statement* row) const {
    if (slice.channel < 0) return row != nullptr ? row->text : "its blocks";
    const trace::Channel& channel = trace_.channels[static_cast<std::size_t>(slice.channel)];
    if (row != nullptr && row->text.rfind("TXM", 0) == 0)
      return "room for " + channel.message + " to " + channel.receiver;
    return channel.message + " from " + channel.sender;
  }

  void add_event(const Event& event) {
    const auto subject = static_cast<std::size_t>(event.subject);
    switch (event.kind) {
      case Kind::put:
        put(event);
        break;
      case Kind::take:
      case Kind::drop:
        arrive(event);
        break;
      case Kind::set:
        if (event.subject >= 0)
          timeline_.waveforms[subject].sets.push_back({event.time_ns, event.value != 0, event.actor});
        break;
      case Kind::read:
        if (event.subject >= 0)
          timeline_.waveforms[subject].reads.push_back({event.time_ns, event.value != 0, event.actor});
        break;
      case Kind::overrun:
        mark(event, MarkKind::overrun, message(event) + " is lost: the one before was not taken");
        break;
      case Kind::give_up:
        mark(event, MarkKind::gave_up, "gives up waiting for " + message(event));
        break;
      case Kind::cancel:
        mark(event, MarkKind::cancelled, "is cancelled");
        break;
      case Kind::complete:
        mark(event, MarkKind::completion, "completion " + std::to_string(event.value));
        break;
      case Kind::fault:
        mark(event, MarkKind::fault,
             event.value >= 0 ? trace_.faults[static_cast<std::size_t>(event.value)] : std::string("fault"));
        break;
      case Kind::broken:
        mark(event, MarkKind::broken, trace_.promises[static_cast<std::size_t>(event.value)]);
        break;
      default:
        break;
    }
  }

  std::string message(const Event& event) const {
    return event.subject < 0 ? std::string()
                             : trace_.channels[static_cast<std::size_t>(event.subject)].message;
  }

  void mark(const Event& event, MarkKind kind, std::string text) {
    timeline_.marks.push_back({event.time_ns, kind, event.actor, std::move(text)});
  }

  void put(const Event& event) {
    if (event.actor < 0 || event.subject < 0) return;
    // What a device says of itself is an event; what it says at the end of its work is an answer.
    const Lane& sender = lane(event.actor);
    if (sender.device && !serves_until(sender, event.time_ns)) mark(event, MarkKind::event, message(event));
    under_way_[{event.subject, event.value}] = {
        static_cast<std::size_t>(event.actor), event.time_ns, -1, 0, 0, message(event), Fate::taken};
  }

  static bool serves_until(const Lane& device, std::int64_t instant) {
    return std::any_of(device.bars.begin(), device.bars.end(),
                       [&](const Bar& bar) { return bar.to_ns == instant; });
  }

  void arrive(const Event& event) {
    const auto found = under_way_.find({event.subject, event.value});
    if (found == under_way_.end()) return;
    Arrow arrow = found->second;
    under_way_.erase(found);
    arrow.taken_ns = arrow.to_ns = event.time_ns;
    arrow.to_lane = event.actor;
    if (event.kind == Kind::drop) arrow.fate = Fate::dropped;
    // The message was there when the action that takes it began.
    if (event.kind == Kind::take && event.actor >= 0) {
      for (const Bar& bar : lane(event.actor).bars) {
        if (bar.to_ns == event.time_ns && bar.kind == BarKind::message) {
          arrow.to_ns = std::max(bar.from_ns, arrow.from_ns);
          break;
        }
      }
    }
    timeline_.arrows.push_back(arrow);
  }

  // A device's work is named by the message that it ends with.
  void name_what_devices_serve() {
    for (const Arrow& arrow : timeline_.arrows) {
      for (Bar& bar : timeline_.lanes[arrow.from_lane].bars) {
        if (bar.kind == BarKind::serving && bar.to_ns == arrow.from_ns) bar.text = arrow.message;
      }
    }
  }

  void put_in_order() {
    const std::vector<std::size_t> order = lane_order(timeline_);
    std::vector<std::size_t> place(order.size());
    std::vector<Lane> lanes;
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = i;
      lanes.push_back(std::move(timeline_.lanes[order[i]]));
    }
    timeline_.lanes = std::move(lanes);
    const auto moved = [&](std::int64_t lane) {
      return lane < 0 ? lane : static_cast<std::int64_t>(place[static_cast<std::size_t>(lane)]);
    };
    for (Arrow& arrow : timeline_.arrows) {
      arrow.from_lane = place[arrow.from_lane];
      arrow.to_lane = moved(arrow.to_lane);
    }
    std::stable_sort(timeline_.arrows.begin(), timeline_.arrows.end(), [](const Arrow& a, const Arrow& b) {
      return std::tie(a.from_ns, a.to_ns, a.from_lane) < std::tie(b.from_ns, b.to_ns, b.from_lane);
    });
    for (Waveform& wave : timeline_.waveforms) {
      for (Sample& sample : wave.sets) sample.lane = moved(sample.lane);
      for (Sample& sample : wave.reads) sample.lane = moved(sample.lane);
    }
    for (Mark& it : timeline_.marks) it.lane = moved(it.lane);
  }

  const Trace& trace_;
  Timeline timeline_;
  std::map<std::pair<std::int32_t, std::int32_t>, Arrow> under_way_;  // by channel and serial number
  std::map<std::pair<std::int32_t, std::int32_t>, bool> broken_off_;  // by actor and statement
};

}  // namespace

Timeline timeline(const Trace& trace) {
  return Builder(trace).build();
}

}  // namespace pal::analyzer::chart
