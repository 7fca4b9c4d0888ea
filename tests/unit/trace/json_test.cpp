// The JSON form of a trace. What is written is read back the same, and malformed text is refused with a
// reason.
#include <catch2/catch.hpp>
#include <locale>
#include <random>
#include <sstream>

#include "pal/trace/kind.hpp"
#include "pal/trace/trace.hpp"

namespace pal::trace {
namespace {

/// Every field equal; Actor and the other rows have no operator of their own.
void expect_same(const Trace& a, const Trace& b) {
  REQUIRE(a.skill == b.skill);
  REQUIRE(a.environment == b.environment);
  REQUIRE(a.origin == b.origin);
  REQUIRE(a.conditions == b.conditions);
  REQUIRE(a.faults == b.faults);
  REQUIRE(a.events == b.events);
  REQUIRE(a.actors.size() == b.actors.size());
  for (std::size_t i = 0; i < a.actors.size(); ++i) {
    REQUIRE(a.actors[i].name == b.actors[i].name);
    REQUIRE(a.actors[i].device == b.actors[i].device);
    REQUIRE(a.actors[i].processor == b.actors[i].processor);
    REQUIRE(a.actors[i].priority == b.actors[i].priority);
  }
  REQUIRE(a.statements.size() == b.statements.size());
  for (std::size_t i = 0; i < a.statements.size(); ++i) {
    REQUIRE(a.statements[i].module == b.statements[i].module);
    REQUIRE(a.statements[i].text == b.statements[i].text);
    REQUIRE(a.statements[i].file == b.statements[i].file);
    REQUIRE(a.statements[i].line == b.statements[i].line);
  }
  REQUIRE(a.channels.size() == b.channels.size());
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    REQUIRE(a.channels[i].sender == b.channels[i].sender);
    REQUIRE(a.channels[i].message == b.channels[i].message);
    REQUIRE(a.channels[i].receiver == b.channels[i].receiver);
  }
}

/// Any trace that the form allows, with the characters that JSON has to escape.
class RandomTrace {
 public:
  explicit RandomTrace(unsigned seed) : random_(seed) {}

  Trace make() {
    Trace trace;
    trace.skill = text();
    trace.environment = text();
    trace.origin = text();
    for (int i = number(0, 4); i > 0; --i) {
      Actor actor{text(), number(0, 1) == 1, {}, 0};
      if (!actor.device) {
        actor.processor = text();
        actor.priority = number(-3, 9);
        const int parent = number(-1, static_cast<int>(trace.actors.size()) - 1);
        if (parent >= 0 && !trace.actors[static_cast<std::size_t>(parent)].device) actor.parent = parent;
      }
      trace.actors.push_back(actor);
    }
    for (int i = number(0, 4); i > 0; --i)
      trace.statements.push_back({text(), text(), text(), number(0, 900)});
    for (int i = number(0, 4); i > 0; --i) trace.channels.push_back({text(), text(), text()});
    for (int i = number(0, 3); i > 0; --i) trace.conditions.push_back(text());
    for (int i = number(0, 3); i > 0; --i) trace.faults.push_back(text());
    std::int64_t time = 0;
    for (int i = number(0, 40); i > 0; --i) trace.events.push_back(event(trace, time));
    return trace;
  }

 private:
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  std::string text() {
    static const std::vector<std::string> pieces = {"SM1", "\"", "\\",   "\n", "\t", std::string(1, '\x01'),
                                                    "ü",   "µs", "🤖", "/",  "{",  "<&>"};
    std::string result;
    for (int i = number(0, 5); i > 0; --i) result += pieces[static_cast<std::size_t>(number(0, 11))];
    return result;
  }

  std::int32_t index(std::size_t size) { return number(-1, static_cast<int>(size) - 1); }

  Event event(const Trace& trace, std::int64_t& time) {
    time += std::uniform_int_distribution<std::int64_t>(0, 1LL << number(0, 55))(random_);
    Event result{time,
                 static_cast<Kind>(number(0, 16)),
                 index(trace.actors.size()),
                 index(trace.statements.size()),
                 number(-1, 99),
                 number(-5, 1 << 30)};
    if (subject_table(result.kind) == SubjectTable::channels) result.subject = index(trace.channels.size());
    if (subject_table(result.kind) == SubjectTable::conditions)
      result.subject = index(trace.conditions.size());
    if (result.kind == Kind::fault) result.value = index(trace.faults.size());
    return result;
  }

  std::mt19937 random_;
};

std::string written(const Trace& trace) {
  std::ostringstream out;
  write_json(trace, out);
  return out.str();
}

Trace read(const std::string& text) {
  std::istringstream in(text);
  return read_json(in);
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST_CASE("a trace that is written and read is the same trace") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  RandomTrace random(seed);
  for (int i = 0; i < 500; ++i) {
    const Trace trace = random.make();
    const std::string text = written(trace);
    const Trace again = read(text);
    expect_same(trace, again);
    REQUIRE(written(again) == text);
  }
}

TEST_CASE("the spelling of every kind is read back as that kind") {
  for (int i = 0; i <= static_cast<int>(Kind::fault); ++i) {
    CHECK(kind_named(name(static_cast<Kind>(i))) == static_cast<Kind>(i));
  }
  CHECK_FALSE(kind_named("begin"));
}

TEST_CASE("events are written one a line") {
  Trace trace;
  trace.skill = "touch";
  trace.actors = {{"SM1", false, "P0", 1}, {"alter", true, "", 0}, {"SM1.1", false, "P0", 1, 0}};
  trace.events = {{28000000, Kind::busy, 1, -1, -1, 0}};
  CHECK(written(trace) == R"({
"format": "pal-trace",
"version": 1,
"skill": "touch",
"environment": "",
"origin": "",
"actors": [
{"name":"SM1","processor":"P0","priority":1},
{"name":"alter","device":true},
{"name":"SM1.1","processor":"P0","priority":1,"parent":0}
],
"statements": [],
"channels": [],
"conditions": [],
"faults": [],
"events": [
[28000000,"busy",1,-1,-1,0]
]
}
)");
}

TEST_CASE("a stream with a locale that groups digits gets the same bytes") {
  struct Grouped : std::numpunct<char> {
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  Trace trace;
  trace.actors = {{"SM1", false, "P0", 1000000}};
  trace.events = {{28000000, Kind::start, 0, -1, -1, 1234567}};
  std::ostringstream json, chrome, plain;
  json.imbue(std::locale(std::locale::classic(), new Grouped));
  chrome.imbue(json.getloc());
  write_json(trace, json);
  write_chrome(trace, chrome);
  write_chrome(trace, plain);
  CHECK(json.str() == written(trace));
  CHECK(chrome.str() == plain.str());
}

TEST_CASE("what is not a trace is refused with the place and the reason") {
  Trace trace;
  trace.actors = {{"SM1", false, "P0", 1}};
  trace.conditions = {"pc-force"};
  trace.events = {{5, Kind::start, 0, -1, -1, 0}, {7, Kind::set, 0, -1, 0, 1}};
  const std::string good = written(trace);
  REQUIRE(refusal(good) == "accepted");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return refusal(text.replace(at, from.size(), to));
  };

  CHECK_THAT(refusal(""), Catch::StartsWith("not JSON: parse error at line 1"));
  CHECK_THAT(refusal("{\n\"format\": oops"), Catch::StartsWith("not JSON: parse error at line 2"));
  CHECK_THAT(refusal(good.substr(0, good.size() / 2)), Catch::StartsWith("not JSON: "));
  CHECK(refusal("[]") == "not a pal trace: the file: expected an object");
  CHECK(refusal("{}") == "not a pal trace: the file: \"format\" is missing");
  CHECK(with("pal-trace", "chrome") == "not a pal trace: format: expected \"pal-trace\"");
  CHECK(with("\"version\": 1", "\"version\": 2") ==
        "not a pal trace: version: only version 1 can be read, this is 2");
  CHECK(with("\"skill\": \"\"", "\"skill\": 3") == "not a pal trace: the file.skill: expected a text");
  CHECK(with("\"events\"", "\"event\"") == "not a pal trace: the file: \"events\" is missing");
  CHECK(with("\"processor\"", "\"process\"") == "not a pal trace: actors[0]: \"processor\" is missing");
  CHECK(with("\"priority\":1", "\"priority\":1.5") ==
        "not a pal trace: actors[0].priority: expected a whole number");
  CHECK(with("[\n{\"name\":\"SM1\",\"processor\":\"P0\",\"priority\":1}\n]", "{}") ==
        "not a pal trace: actors: expected a list");
  CHECK(with("\"start\"", "\"begin\"") == "not a pal trace: events[0]: there is no event \"begin\"");
  CHECK(with("[5,\"start\",0,-1,-1,0]", "[5,\"start\",0]") ==
        "not a pal trace: events[0]: expected [time, kind, actor, statement, subject, value]");
  CHECK(with("\"start\",0", "\"start\",1") == "not a pal trace: events[0]: there is no actor 1");
  CHECK(with("\"start\",0,-1", "\"start\",0,-2") == "not a pal trace: events[0]: there is no statement -2");
  CHECK(with("\"set\",0,-1,0", "\"set\",0,-1,1") == "not a pal trace: events[1]: there is no condition 1");
  CHECK(with("\"set\",0,-1,0,1", "\"fault\",0,-1,0,0") == "not a pal trace: events[1]: there is no fault 0");
  CHECK(with("[5,", "[5e9,") == "not a pal trace: events[0] time: expected a whole number");
  CHECK(with("[5,", "[18446744073709551615,") == "not a pal trace: events[0] time: the number is too large");
  CHECK(with("[5,\"start\",0", "[5,\"start\",4294967296") ==
        "not a pal trace: events[0] actor: the number is too large");
  CHECK(with("[5,", "[8,") == "not a pal trace: events[1]: time runs backwards");
  CHECK(with("[5,", "[-1,") == "not a pal trace: events[0]: time runs backwards");
}

}  // namespace
}  // namespace pal::trace
