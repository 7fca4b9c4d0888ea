// A trace written as JSON.
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "pal/trace/spool.hpp"
#include "pal/trace/trace.hpp"

namespace pal::trace {

namespace {

using Json = nlohmann::ordered_json;

// Texts are UTF-8; bytes that are not become U+FFFD, so that the file is always JSON.
std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// One row a line: people read these files, and compare them line by line.
template <class Rows, class Write>
void table(std::ostream& out, const char* name, const Rows& rows, Write write, const char* end) {
  out << '"' << name << "\": [";
  const char* separator = "\n";
  for (const auto& row : rows) {
    out << separator;
    write(row);
    separator = ",\n";
  }
  out << (rows.empty() ? "]" : "\n]") << end;
}

Json actor(const Actor& actor) {
  Json json = {{"name", actor.name}};
  if (actor.device) {
    json["device"] = true;
  } else {
    json["processor"] = actor.processor;
    json["priority"] = actor.priority;
    if (actor.parent >= 0) json["parent"] = actor.parent;
  }
  return json;
}

}  // namespace

void write_json(const Trace& trace, std::ostream& out) {
  write_json(trace, events_of(trace), out);
}

void write_json(const Trace& trace, const EventSource& events, std::ostream& out) {
  out << "{\n\"format\": \"pal-trace\",\n\"version\": 1,\n";
  out << "\"skill\": " << text(trace.skill) << ",\n";
  out << "\"environment\": " << text(trace.environment) << ",\n";
  out << "\"origin\": " << text(trace.origin) << ",\n";
  table(
      out, "actors", trace.actors, [&](const Actor& row) { out << text(actor(row)); }, ",\n");
  table(
      out, "statements", trace.statements,
      [&](const Statement& row) {
        out << text({{"module", row.module}, {"text", row.text}, {"file", row.file}, {"line", row.line}});
      },
      ",\n");
  table(
      out, "channels", trace.channels,
      [&](const Channel& row) {
        out << text({{"sender", row.sender}, {"message", row.message}, {"receiver", row.receiver}});
      },
      ",\n");
  table(
      out, "conditions", trace.conditions, [&](const std::string& row) { out << text(row); }, ",\n");
  table(
      out, "faults", trace.faults, [&](const std::string& row) { out << text(row); }, ",\n");
  if (!trace.promises.empty())
    table(
        out, "promises", trace.promises, [&](const std::string& row) { out << text(row); }, ",\n");
  out << "\"events\": [";
  const char* separator = "\n";
  events([&](const Event& row) {
    // std::to_string, since a stream's locale may group digits.
    out << separator << '[' << std::to_string(row.time_ns) << ",\"" << name(row.kind) << "\","
        << std::to_string(row.actor) << ',' << std::to_string(row.statement) << ','
        << std::to_string(row.subject) << ',' << std::to_string(row.value) << ']';
    separator = ",\n";
  });
  out << (*separator == '\n' ? "]\n" : "\n]\n");
  out << "}\n";
}

}  // namespace pal::trace
