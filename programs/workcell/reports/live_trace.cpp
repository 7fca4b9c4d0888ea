#include "programs/workcell/reports/live_trace.hpp"

#include <signal.h>

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pal/trace/trace.hpp"

namespace pal::workcell {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto look_each = std::chrono::milliseconds(5);

Json tables_json(const trace::Trace& tables) {
  Json json{{"format", "pal-live-trace"}, {"version", 1},
            {"skill", tables.skill},      {"environment", tables.environment},
            {"actors", Json::array()},    {"statements", Json::array()},
            {"channels", Json::array()},  {"conditions", tables.conditions}};
  for (const trace::Actor& row : tables.actors) {
    Json actor{{"name", row.name}};
    if (row.device) {
      actor["device"] = true;
    } else {
      actor["processor"] = row.processor;
      actor["priority"] = row.priority;
      if (row.parent >= 0) actor["parent"] = row.parent;
    }
    json["actors"].push_back(std::move(actor));
  }
  for (const trace::Statement& row : tables.statements)
    json["statements"].push_back(
        {{"module", row.module}, {"text", row.text}, {"file", row.file}, {"line", row.line}});
  for (const trace::Channel& row : tables.channels)
    json["channels"].push_back(
        {{"sender", row.sender}, {"message", row.message}, {"receiver", row.receiver}});
  return json;
}

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

LiveTrace::LiveTrace(const std::string& file, const runtime::Wiring& wiring, std::size_t capacity)
    : ring_(capacity),
      out_(file, std::ios::binary),
      first_(line_of(tables_json(runtime::trace_tables(wiring)))) {
  if (!out_) throw std::runtime_error("the file cannot be written");
  writer_ = std::thread([this] { write(); });
}

LiveTrace::~LiveTrace() {
  stop();
}

void LiveTrace::stop() {
  over_.store(true, std::memory_order_release);
  if (writer_.joinable()) writer_.join();
}

void LiveTrace::write() {
  // A reader that goes is an error of the stream, not the end of the process.
  sigset_t broken_pipe;
  ::sigemptyset(&broken_pipe);
  ::sigaddset(&broken_pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
  out_ << first_ << std::flush;
  while (!over_.load(std::memory_order_acquire)) {
    write_what_is_there();
    std::this_thread::sleep_for(look_each);
  }
  write_what_is_there();
  out_ << last_ << std::flush;
  out_.close();  // here, where a broken pipe ends nothing
}

void LiveTrace::write_what_is_there() {
  std::array<trace::Event, 256> events;
  bool any = false;
  while (const std::size_t count = ring_.take(events)) {
    any = true;
    for (std::size_t i = 0; i < count; ++i) {
      const trace::Event& event = events[i];
      out_ << '[' << event.time_ns << ",\"" << trace::name(event.kind) << "\"," << event.actor << ','
           << event.statement << ',' << event.subject << ',' << event.value << "]\n";
    }
  }
  if (any) out_ << std::flush;
}

bool LiveTrace::end(const runtime::Outcome& outcome) {
  last_ = line_of({{"completion", outcome.code},
                   {"fault", outcome.fault},
                   {"reason", outcome.reason},
                   {"faults", outcome.trace.faults},
                   {"promises", outcome.trace.promises},
                   {"dropped", ring_.dropped()}});
  stop();
  return static_cast<bool>(out_);
}

}  // namespace pal::workcell
