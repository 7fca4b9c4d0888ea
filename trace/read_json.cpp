// A trace read from JSON.
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pal/trace/kind.hpp"
#include "pal/trace/trace.hpp"

namespace pal::trace {

namespace {

using ParsedJson = nlohmann::json;

[[noreturn]] void fail(const std::string& where, const std::string& what) {
  throw std::runtime_error("not a pal trace: " + where + ": " + what);
}

const ParsedJson& member(const ParsedJson& object, const char* key, const std::string& where) {
  if (!object.is_object()) fail(where, "expected an object");
  const auto found = object.find(key);
  if (found == object.end()) fail(where, std::string("\"") + key + "\" is missing");
  return *found;
}

std::string text(const ParsedJson& object, const char* key, const std::string& where) {
  const ParsedJson& value = member(object, key, where);
  if (!value.is_string()) fail(where + "." + key, "expected a text");
  return value.get<std::string>();
}

template <class Integer>
Integer integer(const ParsedJson& value, const std::string& where) {
  constexpr auto low = std::numeric_limits<Integer>::min();
  constexpr auto high = std::numeric_limits<Integer>::max();
  if (!value.is_number_integer()) fail(where, "expected a whole number");
  // nlohmann keeps what does not fit into 64 bits with a sign as unsigned.
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(high)) {
    fail(where, "the number is too large");
  }
  const auto wide = value.get<std::int64_t>();
  if (wide < low || wide > high) fail(where, "the number is out of range");
  return static_cast<Integer>(wide);
}

template <class Row, class List = std::vector<Row>, class Read>
List read_table(const ParsedJson& root, const char* key, Read read) {
  const ParsedJson& rows = member(root, key, "the file");
  if (!rows.is_array()) fail(key, "expected a list");
  List result;
  result.reserve(rows.size());
  for (const ParsedJson& row : rows) {
    result.push_back(read(row, std::string(key) + "[" + std::to_string(result.size()) + "]"));
  }
  return result;
}

std::string plain_text(const ParsedJson& value, const std::string& where) {
  if (!value.is_string()) fail(where, "expected a text");
  return value.get<std::string>();
}

Actor read_actor(const ParsedJson& row, const std::string& where) {
  Actor result;
  result.name = text(row, "name", where);
  if (const auto device = row.find("device"); device != row.end()) {
    if (!device->is_boolean()) fail(where + ".device", "expected true or false");
    result.device = device->get<bool>();
  }
  if (!result.device) {
    result.processor = text(row, "processor", where);
    result.priority = integer<int>(member(row, "priority", where), where + ".priority");
    if (const auto parent = row.find("parent"); parent != row.end()) {
      result.parent = integer<std::int32_t>(*parent, where + ".parent");
    }
  }
  return result;
}

Statement statement(const ParsedJson& row, const std::string& where) {
  return {text(row, "module", where), text(row, "text", where), text(row, "file", where),
          integer<int>(member(row, "line", where), where + ".line")};
}

Channel channel(const ParsedJson& row, const std::string& where) {
  return {text(row, "sender", where), text(row, "message", where), text(row, "receiver", where)};
}

Event event(const ParsedJson& row, const std::string& where) {
  if (!row.is_array() || row.size() != 6)
    fail(where, "expected [time, kind, actor, statement, subject, value]");
  Event result;
  result.time_ns = integer<std::int64_t>(row[0], where + " time");
  const std::string kind = plain_text(row[1], where + " kind");
  const auto known = kind_named(kind);
  if (!known) fail(where, "there is no event \"" + kind + "\"");
  result.kind = *known;
  result.actor = integer<std::int32_t>(row[2], where + " actor");
  result.statement = integer<std::int32_t>(row[3], where + " statement");
  result.subject = integer<std::int32_t>(row[4], where + " subject");
  result.value = integer<std::int32_t>(row[5], where + " value");
  return result;
}

void check_index(std::int32_t index, std::size_t size, const std::string& where, const char* what) {
  if (index < -1 || (index >= 0 && static_cast<std::size_t>(index) >= size)) {
    fail(where, std::string("there is no ") + what + " " + std::to_string(index));
  }
}

/// A block of CONCURRENT is begun by another thread.
void check_parents(const Trace& trace) {
  for (std::size_t i = 0; i < trace.actors.size(); ++i) {
    const std::int32_t parent = trace.actors[i].parent;
    const std::string where = "actors[" + std::to_string(i) + "].parent";
    check_index(parent, trace.actors.size(), where, "actor");
    if (parent < 0) continue;
    if (parent == static_cast<std::int32_t>(i) || trace.actors[static_cast<std::size_t>(parent)].device)
      fail(where, "expected another thread");
  }
}

void check(const Trace& trace) {
  check_parents(trace);
  std::int64_t before = 0;
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    const Event& event = trace.events[i];
    const std::string where = "events[" + std::to_string(i) + "]";
    if (event.time_ns < before) fail(where, "time runs backwards");
    before = event.time_ns;
    check_index(event.actor, trace.actors.size(), where, "actor");
    check_index(event.statement, trace.statements.size(), where, "statement");
    const SubjectTable subjects = subject_table(event.kind);
    if (subjects == SubjectTable::channels)
      check_index(event.subject, trace.channels.size(), where, "channel");
    if (subjects == SubjectTable::conditions) {
      check_index(event.subject, trace.conditions.size(), where, "condition");
    }
    if (event.kind == Kind::fault) check_index(event.value, trace.faults.size(), where, "fault");
    if (event.kind == Kind::broken) check_index(event.value, trace.promises.size(), where, "promise");
    if (event.kind == Kind::broken && event.value < 0) fail(where, "names no promise");
  }
}

Trace from_json(const ParsedJson& root) {
  if (!root.is_object()) fail("the file", "expected an object");
  if (text(root, "format", "the file") != "pal-trace") fail("format", "expected \"pal-trace\"");
  if (const int version = integer<int>(member(root, "version", "the file"), "version"); version != 1) {
    fail("version", "only version 1 can be read, this is " + std::to_string(version));
  }
  Trace trace;
  trace.skill = text(root, "skill", "the file");
  trace.environment = text(root, "environment", "the file");
  trace.origin = text(root, "origin", "the file");
  trace.actors = read_table<Actor>(root, "actors", read_actor);
  trace.statements = read_table<Statement>(root, "statements", statement);
  trace.channels = read_table<Channel>(root, "channels", channel);
  trace.conditions = read_table<std::string>(root, "conditions", plain_text);
  trace.faults = read_table<std::string>(root, "faults", plain_text);
  if (root.contains("promises")) trace.promises = read_table<std::string>(root, "promises", plain_text);
  trace.events = read_table<Event, Events>(root, "events", event);
  check(trace);
  return trace;
}

}  // namespace

Trace read_json(std::istream& in) {
  ParsedJson root;
  try {
    root = ParsedJson::parse(in);
  } catch (const ParsedJson::exception& error) {
    // The library's own text begins with its error number; what follows names line and column.
    const std::string what = error.what();
    const std::size_t text = what.find("] ");
    throw std::runtime_error("not JSON: " + (text == std::string::npos ? what : what.substr(text + 2)));
  }
  return from_json(root);
}

}  // namespace pal::trace
