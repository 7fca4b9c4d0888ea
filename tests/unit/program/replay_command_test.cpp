// pal check --witness and pal replay.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "pal/support/file_system.hpp"
#include "tests/unit/program/program.hpp"

using namespace pal::test;
using pal::program::ExitStatus;
using OrderedJson = nlohmann::ordered_json;

namespace {

/// A file of this test that goes with it.
class File {
 public:
  explicit File(const std::string& name)
      : path_((std::filesystem::temp_directory_path() / (pal::test::own_name("pal_" + name) + ".json"))
                  .string()) {}
  ~File() { std::filesystem::remove(path_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const std::string& path() const { return path_; }
  OrderedJson read() const {
    std::ifstream in(path_);
    return OrderedJson::parse(in);
  }
  void write(const OrderedJson& json) const { std::ofstream(path_) << json.dump(1); }

 private:
  std::string path_;
};

Answer replayed(const File& file, const std::string& skill) {
  return pal::test::pal({"replay", file.path(), skill, "-e", cell});
}

}  // namespace

TEST_CASE("check --witness writes a run for each requirement, and replay confirms them all") {
  const File file("replay_confirms");
  CHECK(pal::test::pal({"check", read_first, "-e", cell, "--witness", file.path()}).status ==
        ExitStatus::not_met);
  CHECK(file.read().at("witnesses").size() == 4);
  const Answer answer = replayed(file, read_first);
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(answer.out.find("confirmed  fresh-force of touch-read-first in workcell: age 35.35 ms") !=
        std::string::npos);
  CHECK(answer.out.find("refused") == std::string::npos);
}

TEST_CASE("a file of very many runs is read, however large a text may be") {
  const File file("replay_large");
  pal::test::pal({"check", read_first, "-e", cell, "--witness", file.path()});
  std::ofstream(file.path(), std::ios::app) << std::string(pal::largest_file, ' ');
  CHECK(replayed(file, read_first).status == ExitStatus::all_hold);
}

TEST_CASE("replay refuses a witness of other texts, of another value, and of another run") {
  const File file("replay_refuses");
  pal::test::pal({"check", read_first, "-e", cell, "--witness", file.path()});
  const OrderedJson sound = file.read();

  OrderedJson other = sound;
  for (OrderedJson& each : other["witnesses"]) each["identity"] = "0123456789abcdef";
  file.write(other);
  CHECK(replayed(file, read_first).out.find("another version of these files") != std::string::npos);

  OrderedJson value = sound;
  for (OrderedJson& each : value["witnesses"]) {
    if (each["requirement"] == "fresh-force") each["value_ns"] = 36'000'000;
  }
  file.write(value);
  const Answer more = replayed(file, read_first);
  CHECK(more.status == ExitStatus::not_met);
  CHECK(more.out.find("it does not show 36 ms") != std::string::npos);

  OrderedJson shorter = sound;
  for (OrderedJson& each : shorter["witnesses"])
    each["run"]["events"].erase(each["run"]["events"].begin() + 3);
  file.write(shorter);
  CHECK(replayed(file, read_first).status == ExitStatus::not_met);
}

TEST_CASE("replay refuses events of messages without saying of which") {
  const File file("replay_of_nothing");
  pal::test::pal({"check", read_first, "-e", cell, "--witness", file.path()});
  const OrderedJson sound = file.read();
  for (const char* kind : {"put", "take", "drop", "overrun"}) {
    OrderedJson changed = sound;
    for (OrderedJson& each : changed["witnesses"]) {
      OrderedJson& event = each["run"]["events"].at(5);
      event[1] = kind;
      event[4] = -1;
    }
    file.write(changed);
    const Answer answer = replayed(file, read_first);
    CHECK(answer.status == ExitStatus::not_met);
    CHECK(answer.out.find("an event names what is in no table") != std::string::npos);
  }
}

TEST_CASE("replay says when there is no such file, or no witness in it") {
  const File file("replay_none");
  CHECK(replayed(file, touch).status == ExitStatus::usage);
  file.write(OrderedJson::object());
  const Answer answer = replayed(file, touch);
  CHECK(answer.status == ExitStatus::usage);
  CHECK(answer.err.find("is no file of witnesses: it is not {\"witnesses\": [...]}") != std::string::npos);
  file.write({{"witnesses", nullptr}});
  CHECK(replayed(file, touch).status == ExitStatus::usage);
  file.write({{"witnesses", {{{"skill", 1}}}}});
  CHECK(replayed(file, touch).err.find("witnesses[0]: ") != std::string::npos);
  file.write({{"witnesses", OrderedJson::array()}});
  CHECK(replayed(file, touch).out == "nothing to confirm: the file has no run\n");
}

TEST_CASE("replay refuses what no run says, whatever stands in the file") {
  const File file("replay_nonsense");
  pal::test::pal({"check", read_first, "-e", cell, "--witness", file.path()});
  OrderedJson first = file.read();
  first["witnesses"] = OrderedJson::array({first["witnesses"][1]});
  REQUIRE(first["witnesses"][0]["measure"] == "age");
  file.write(first);
  REQUIRE(replayed(file, read_first).status == ExitStatus::all_hold);

  const auto refused = [&](const auto& change, const std::string& why) {
    OrderedJson other = first;
    change(other["witnesses"][0]);
    file.write(other);
    const Answer answer = replayed(file, read_first);
    INFO(answer.out << answer.err);
    CHECK(answer.status == ExitStatus::not_met);
    CHECK(answer.out.find(why) != std::string::npos);
  };
  const auto with_event = [](const std::string& kind, const auto& change) {
    return [kind, change](OrderedJson& witness) {
      for (OrderedJson& event : witness["run"]["events"]) {
        if (event[1] != kind) continue;
        change(event);
        return;
      }
    };
  };
  for (const std::string kind : {"put", "take"})
    refused(with_event(kind, [](OrderedJson& event) { event[4] = -1; }), "names what is in no table");
  refused(with_event("take", [](OrderedJson& event) { event[5] = 1'000'000; }), "the number of another");
  refused(with_event("block", [](OrderedJson& event) { event[4] = event[4] == 0 ? 1 : 0; }),
          "does not wait for here");
  refused(with_event("set", [](OrderedJson& event) { event[5] = 7; }), "another value than 0 and 1");
  refused(
      [](OrderedJson& witness) {
        witness["run"]["events"].back()[0] = std::numeric_limits<std::int64_t>::max();
      },
      "at no instant of a run");
  refused([](OrderedJson& witness) { witness["measure"] = "busy"; }, "measures something else");
  refused([](OrderedJson& witness) { witness["run"]["actors"][0]["priority"] = 99; },
          "another place, priority or parent");
  refused([](OrderedJson& witness) { witness["run"]["channels"][0]["sender"] = "no-such-thread"; },
          "another channel");
  // A value that has grown since before all times, up to an instant before all times: no such numbers.
  refused(
      [](OrderedJson& witness) {
        witness["grows"] = true;
        witness["at_ns"] = std::numeric_limits<std::int64_t>::min();
        witness["value_ns"] = 1'000'000;
      },
      "no instant of a run");
}

TEST_CASE("runs that a simulation found prove what the exact analysis has given up") {
  const std::string places = std::string(PAL_SOURCE_DIR) + "/tests/reference/figure_3_6_places.pal";
  const File file("replay_given_up");
  pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "1", "--priorities",
                  "--max-states", "1", "--witness", file.path()});
  CHECK(file.read().at("witnesses").size() == 13);
  CHECK(pal::test::pal({"replay", file.path(), places}).status == ExitStatus::all_hold);
}

TEST_CASE("a run for each placement proves that one processor does not suffice") {
  const std::string places = std::string(PAL_SOURCE_DIR) + "/tests/reference/figure_3_6_places.pal";
  const File file("replay_placements");
  CHECK(pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "1", "--priorities",
                        "--witness", file.path()})
            .status == ExitStatus::not_met);
  OrderedJson runs = file.read();
  CHECK(runs.at("witnesses").size() == 13);
  const Answer json = pal::test::pal({"whatif", places, "--environment-name", "reading", "--place", "1",
                                      "--priorities", "--witness", file.path(), "--format", "json"});
  CHECK(OrderedJson::parse(json.out).contains("what_if"));
  const Answer confirmed = pal::test::pal({"replay", file.path(), places});
  CHECK(confirmed.status == ExitStatus::all_hold);
  CHECK(confirmed.out.find("refused") == std::string::npos);

  // The run of one placement is none of another.
  runs.at("witnesses").at(0).at("placement") = runs.at("witnesses").at(1).at("placement");
  file.write(runs);
  const Answer refused = pal::test::pal({"replay", file.path(), places});
  CHECK(refused.status == ExitStatus::not_met);
  CHECK(refused.out.find("it is a run of another version of these files") != std::string::npos);
}

TEST_CASE("a run on the last of very many processors is confirmed") {
  std::ifstream in(std::string(PAL_SOURCE_DIR) + "/tests/differential/hand/all_zero.pal");
  std::string text(std::istreambuf_iterator<char>(in), {});
  const auto insert = [&text](const std::string& before, const std::string& what) {
    text.insert(text.find(before), what);
  };
  // It is not like the others, as a requirement names it.
  insert("END SKILL", "  REQUIREMENT idle : LOAD OF Q129 AT MOST 0 %\n");
  for (int q = 0; q < 130; ++q) insert("  DEVICE clock EVENT", "  PROCESSOR Q" + std::to_string(q) + "\n");
  text.replace(text.find("obey : 0 ms"), 11, "obey : 7 ms");
  const pal::MemoryFileSystem files({{"s.pal", text}});
  const File file("replay_processors");
  CHECK(pal::test::pal({"whatif", "s.pal", "--place", "1", "--witness", file.path()}, files).status ==
        ExitStatus::not_met);
  OrderedJson runs = file.read();
  CHECK(runs.at("witnesses").back().at("placement").at(0).at("processor") == 130);
  pal::MemoryFileSystem with_runs = files;
  with_runs.add("runs.json", runs.dump());
  CHECK(pal::test::pal({"replay", "runs.json", "s.pal"}, with_runs).status == ExitStatus::all_hold);
  runs.at("witnesses").back().at("placement").at(0)["processor"] = 2'000'000'000;
  with_runs.add("runs.json", runs.dump());
  const Answer refused = pal::test::pal({"replay", "runs.json", "s.pal"}, with_runs);
  CHECK(refused.status == ExitStatus::not_met);
  CHECK(refused.out.find("a processor that does not exist") != std::string::npos);
}
