// A trace written for trace viewers of browsers, as "Trace Event Format" (Google, 2016). One
// process a processor, one more for the devices. Slices are complete events ("X"), messages are flows between
// them, conditions are counters ("C"), and the rest are instants ("i").
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>

#include "pal/trace/slices.hpp"
#include "pal/trace/trace.hpp"

namespace pal::trace {

namespace {

using Json = nlohmann::ordered_json;

/// Microseconds with three decimals: exact, whatever the locale.
std::string microseconds(std::int64_t ns) {
  const std::string digits = std::to_string(ns % 1000);
  return std::to_string(ns / 1000) + "." + std::string(3 - digits.size(), '0') + digits;
}

const char* category(State state) {
  switch (state) {
    case State::running:
      return "run";
    case State::ready:
      return "ready";
    case State::waiting:
      return "wait";
    case State::serving:
      return "device";
  }
  return "";
}

class ChromeWriter {
 public:
  ChromeWriter(const Trace& trace, std::ostream& out) : trace_(trace), out_(out) {}

  void write() {
    out_ << "{\"displayTimeUnit\": \"ns\", \"otherData\": "
         << text({{"skill", trace_.skill}, {"environment", trace_.environment}, {"origin", trace_.origin}})
         << ",\n\"traceEvents\": [";
    write_names();
    collect_messages();
    for (const std::string& condition : trace_.conditions) write_counter(condition, 0, 0);
    for (const Slice& slice : slices(trace_)) write_slice(slice);
    for (const Event& event : trace_.events) write_point(event);
    out_ << "\n]}\n";
  }

 private:
  static std::string text(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  std::string statement(std::int32_t index) const {
    return index < 0 ? std::string() : trace_.statements[static_cast<std::size_t>(index)].text;
  }

  // Process 1 holds conditions and the skill's own events; the others are processors in the order of their
  // first thread, the devices last.
  void write_names() {
    process(1, "skill " + trace_.skill);
    std::map<std::string, int> processors;
    int next = 2;
    for (const Actor& actor : trace_.actors) {
      if (actor.device || processors.count(actor.processor) != 0) continue;
      process(next, "processor " + actor.processor);
      processors[actor.processor] = next++;
    }
    const int devices = next;
    process(devices, "devices");
    int thread = 0;
    for (const Actor& actor : trace_.actors) {
      pids_.push_back(actor.device ? devices : processors[actor.processor]);
      event({{"ph", "M"},
             {"name", "thread_name"},
             {"pid", pids_.back()},
             {"tid", ++thread},
             {"args", {{"name", actor.name}}}});
    }
  }

  void process(int pid, const std::string& name) {
    event({{"ph", "M"}, {"name", "process_name"}, {"pid", pid}, {"args", {{"name", name}}}});
    event({{"ph", "M"}, {"name", "process_sort_index"}, {"pid", pid}, {"args", {{"sort_index", pid}}}});
  }

  // A flow is bound to the slice of the statement that puts or takes: the one that has its effect then.
  void collect_messages() {
    for (const Event& event : trace_.events) {
      if (event.kind != Kind::put && event.kind != Kind::take) continue;
      messages_[{event.actor, event.statement, event.time_ns}] = &event;
    }
  }

  void write_slice(const Slice& slice) {
    Json json = start("X", slice.actor);
    const std::string what = statement(slice.statement);
    switch (slice.state) {
      case State::running:
        json["name"] = what;
        break;
      case State::ready:
        json["name"] = "ready: " + what;
        break;
      case State::waiting:
        json["name"] = "waits: " + what;
        break;
      case State::serving:
        json["name"] = "busy";
        break;
    }
    json["cat"] = category(slice.state);
    if (slice.statement >= 0) {
      const Statement& row = trace_.statements[static_cast<std::size_t>(slice.statement)];
      json["args"] = {{"module", row.module}, {"line", row.file + ":" + std::to_string(row.line)}};
    }
    if (slice.ending == Ending::effect) {
      const auto message = messages_.find({slice.actor, slice.statement, slice.to_ns});
      if (message != messages_.end()) bind(json, *message->second);
    }
    timed(json, slice.from_ns, slice.to_ns - slice.from_ns);
  }

  void write_counter(const std::string& condition, int value, std::int64_t time_ns) {
    timed({{"ph", "C"}, {"pid", 1}, {"name", condition}, {"args", {{"value", value}}}}, time_ns, -1);
  }

  void write_point(const Event& event) {
    const auto subject = static_cast<std::size_t>(event.subject);
    switch (event.kind) {
      case Kind::put:
      case Kind::take:
        if (device(event.actor) && event.subject >= 0) {
          Json json = start("X", event.actor);
          json["name"] = trace_.channels[subject].message;
          json["cat"] = "device";
          bind(json, event);
          timed(json, event.time_ns, 0);
        }
        break;
      case Kind::set:
        if (event.subject >= 0) {
          write_counter(trace_.conditions[subject], event.value, event.time_ns);
        }
        break;
      case Kind::read:
        if (event.subject >= 0) {
          instant(event, "reads " + trace_.conditions[subject] + (event.value != 0 ? " TRUE" : " FALSE"));
        }
        break;
      case Kind::drop:
      case Kind::overrun:
      case Kind::give_up: {
        const std::string what = event.kind == Kind::give_up ? "gives up" : name(event.kind);
        instant(event, event.subject >= 0 ? what + ": " + trace_.channels[subject].message : what);
        break;
      }
      case Kind::cancel:
        instant(event, "cancelled");
        break;
      case Kind::complete:
        instant(event, "completion " + std::to_string(event.value));
        break;
      case Kind::fault:
        instant(event, event.value >= 0 ? "fault: " + trace_.faults[static_cast<std::size_t>(event.value)]
                                        : "fault");
        break;
      case Kind::broken:
        instant(event, "broken promise: " + trace_.promises[static_cast<std::size_t>(event.value)]);
        break;
      default:
        break;
    }
  }

  bool device(std::int32_t actor) const {
    return actor >= 0 && trace_.actors[static_cast<std::size_t>(actor)].device;
  }

  Json start(const char* phase, std::int32_t actor) const {
    const bool own = actor >= 0;
    return {{"ph", phase},
            {"pid", own ? pids_[static_cast<std::size_t>(actor)] : 1},
            {"tid", own ? actor + 1 : 0}};
  }

  void instant(const Event& event, const std::string& what) {
    Json json = start("i", event.actor);
    json["name"] = what;
    json["s"] = event.actor >= 0 ? "t" : "g";
    timed(json, event.time_ns, -1);
  }

  static void bind(Json& json, const Event& event) {
    static constexpr char digits[] = "0123456789abcdef";
    const auto id = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(event.subject + 1)) << 32) |
                    static_cast<std::uint32_t>(event.value);
    std::string hex = "0x";
    for (int shift = 60; shift >= 0; shift -= 4) hex += digits[(id >> shift) & 15];
    json["bind_id"] = hex;
    json[event.kind == Kind::put ? "flow_out" : "flow_in"] = true;
  }

  // Times are put in as text: a floating-point number could not hold every nanosecond.
  void timed(const Json& json, std::int64_t time_ns, std::int64_t duration_ns) {
    std::string body = text(json);
    body.pop_back();
    body += ",\"ts\":" + microseconds(time_ns);
    if (duration_ns >= 0) body += ",\"dur\":" + microseconds(duration_ns);
    line(body + "}");
  }

  void event(const Json& json) { line(text(json)); }

  void line(const std::string& body) {
    out_ << (first_ ? "\n" : ",\n") << body;
    first_ = false;
  }

  const Trace& trace_;
  std::ostream& out_;
  std::vector<int> pids_;
  std::map<std::tuple<std::int32_t, std::int32_t, std::int64_t>, const Event*> messages_;
  bool first_ = true;
};

}  // namespace

void write_chrome(const Trace& trace, std::ostream& out) {
  ChromeWriter(trace, out).write();
}

}  // namespace pal::trace
