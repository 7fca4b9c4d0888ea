#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/program/program.hpp"

using namespace pal::test;
using pal::program::ExitStatus;
using Json = nlohmann::json;

TEST_CASE("a skill that meets its requirements") {
  const auto answer = pal::test::pal({"check", touch, "-e", cell});
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(answer.err.empty());
  CHECK(answer.out.find("holds      fresh-force") != std::string::npos);
}

TEST_CASE("a failing skill: which statement uses how old a value, and why") {
  const auto answer = pal::test::pal({"check", read_first, "-e", cell});
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(answer.err.find("'fresh-force' fails: age of pc-force at TXM( motion to MC1 ) in SM1 is 35.35 ms") !=
        std::string::npos);
  CHECK(answer.err.find("6.6 ms: SM1.2 waits at WTM( request motion from MC1 )") != std::string::npos);
  CHECK(answer.err.find("27.15 ms: MC1 waits at WTM( tick from alter )") != std::string::npos);
  CHECK(answer.err.find("hint: read the condition after WTM( request motion from MC1 )") !=
        std::string::npos);
}

TEST_CASE("measured times are compared with declared ones") {
  pal::MemoryFileSystem files;
  files.add("cell.pal", "ENVIRONMENT cell\n  PROCESSOR P0\n  TIME hold : 0.1 ms\nEND ENVIRONMENT\n");
  files.add("fast.pal",
            "ENVIRONMENT cell\n  PROCESSOR P0\n  TIME hold OF MC1 : 90 TO 100 us\nEND ENVIRONMENT\n");
  files.add("slow.pal", "ENVIRONMENT cell\n  PROCESSOR P0\n  TIME hold OF MC1 : 101 us\nEND ENVIRONMENT\n");
  files.add("empty.pal", "MESSAGE a : SIGNAL\n");
  const auto checked = [&](std::vector<std::string> measured) {
    std::vector<std::string> arguments{"check", "cell.pal", "--without-times"};
    for (const std::string& file : measured) arguments.insert(arguments.end(), {"--measured", file});
    return pal::test::pal(arguments, files);
  };
  CHECK(checked({"fast.pal"}).status == ExitStatus::all_hold);
  CHECK(checked({"fast.pal"}).err.empty());
  CHECK(checked({"fast.pal", "slow.pal"}).status == ExitStatus::wrong_specification);
  CHECK_THAT(
      checked({"slow.pal"}).err,
      Catch::Contains("error[PAL0750]: 'hold OF MC1' was measured to take 101 us, and environment cell "
                      "declares at most 100 us"));
  CHECK(checked({"missing.pal"}).status == ExitStatus::usage);
  CHECK(checked({"empty.pal"}).status == ExitStatus::usage);
  CHECK_THAT(checked({"empty.pal"}).err, Catch::Contains("the files of --measured have no ENVIRONMENT"));
}

TEST_CASE("the parts of an explanation add up to the bound") {
  const Json document =
      Json::parse(pal::test::pal({"check", read_first, "-e", cell, "--format", "json"}).out);
  double sum = 0;
  for (const Json& diagnostic : document["diagnostics"]) {
    if (diagnostic["code"] != "PAL0890") continue;
    for (const Json& note : diagnostic["notes"]) {
      const std::string text = note["message"];
      // What is inside a part is indented; of what is left out there is no figure.
      if (text.front() == ' ' || text.rfind("--explain", 0) == 0) continue;
      const double figure = std::stod(text);
      sum += text.find(" us:") != std::string::npos ? figure / 1000 : figure;
    }
  }
  CHECK(sum == Approx(35.35).epsilon(1e-12));
}

TEST_CASE("what is printed below a requirement adds up to its bound, whatever the analysis") {
  for (const std::string analysis : {"exact", "compositional"}) {
    const Json document = Json::parse(
        pal::test::pal({"check", touch, "-e", cell, "--format", "json", "--analysis", analysis}).out);
    int explained = 0;
    for (const Json& row : document["requirements"]) {
      std::int64_t sum = 0;
      bool placed = false;
      for (const Json& each : row["addends"]) {
        sum += each["amount_ns"].get<std::int64_t>();
        placed = placed || each["line"] > 0;
      }
      if (row["addends"].empty()) continue;
      ++explained;
      CHECK(sum == row["bound_ns"]);
      CHECK(placed);
    }
    CHECK(explained == 4);
  }
  const auto answer = pal::test::pal({"check", touch, "-e", cell, "--explain"});
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(answer.out.find("+ 200 us  MC1 runs obey  (") != std::string::npos);
}

TEST_CASE("the printed parts of a load add up, and its limit is as written") {
  std::string text = text_of("two_drivers");
  const std::string before = "REQUIREMENT b : BUSY PERIOD OF P0 AT MOST 50 ms";
  text.replace(text.find(before), before.size(), "REQUIREMENT l : LOAD OF P0 AT MOST 58.57142 %");
  const auto answer = pal::test::pal({"check", "s.pal", "--explain"}, in_memory(text));
  INFO(answer.out << answer.err);
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(answer.out.find("58.58 %  of 58.57142 %  0.01 % too much") != std::string::npos);
  CHECK(answer.out.find("+ 30 %  MC1 runs w, ") != std::string::npos);
  CHECK(answer.out.find("+ 28.5714286 %  MC2 runs v, ") != std::string::npos);
  CHECK(answer.err.find("at most 58.57142 % is required") != std::string::npos);
}

TEST_CASE("the thread that waits for a message on its way takes it") {
  const auto answer =
      pal::test::pal({"check", touch, "-e", cell, "--analysis", "compositional", "--explain"});
  INFO(answer.out);
  CHECK(answer.out.find("+ 50 us  LS1 waits until TXM( request Zforce from LS1 ) has arrived") !=
        std::string::npos);
  CHECK(answer.out.find("SM1.1 waits until TXM( request Zforce") == std::string::npos);
}

TEST_CASE("the JSON form has the documented members and no others") {
  const auto answer = pal::test::pal({"check", read_first, "--environment", cell, "--format", "json"});
  CHECK(answer.status == ExitStatus::not_met);
  const Json document = Json::parse(answer.out);
  REQUIRE(document.size() == 5);
  CHECK(document.at("not_checked").empty());
  CHECK(document.at("format_version") == 1);
  CHECK(document.at("not_kept") == 0);
  for (const Json& diagnostic : document.at("diagnostics")) {
    for (const char* member : {"code", "severity", "file", "line", "column", "message"})
      CHECK(diagnostic.contains(member));
  }
  REQUIRE(document.at("requirements").size() == 4);
  for (const Json& row : document.at("requirements")) {
    CHECK(row.size() == 12);
    for (const char* member : {"name", "skill", "environment", "measure", "limit_ns", "bound_ns", "exact",
                               "attained_ns", "analysis", "verdict", "taken_as_lost", "addends"}) {
      CHECK(row.contains(member));
    }
  }
  const Json& age = document["requirements"][1];
  CHECK(age["name"] == "fresh-force");
  CHECK(age["measure"] == "age");
  CHECK(age["limit_ns"] == 10'000'000);
  CHECK(age["bound_ns"] == 35'350'000);
  CHECK(age["exact"] == true);
  CHECK(age["verdict"] == "fails");
}

TEST_CASE("without an environment check does what needs no times, says so, and does not end with 0") {
  const auto answer = pal::test::pal({"check", touch});
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(answer.out.find("not checked  fresh-force: no environment was given") != std::string::npos);
  CHECK(answer.err.find("no time was checked: no environment was given") != std::string::npos);
  const auto asked_for = pal::test::pal({"check", touch, "--without-times"});
  CHECK(asked_for.status == ExitStatus::all_hold);
  CHECK(asked_for.err.empty());
}

TEST_CASE("a search that is cut short leaves what it did not decide undecided") {
  const auto answer =
      pal::test::pal({"check", touch, "-e", cell, "--max-states", "10", "--analysis", "exact"});
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(answer.out.find("undecided") != std::string::npos);
  CHECK(answer.out.find("holds      fresh-force") == std::string::npos);
}

TEST_CASE("a wrong specification ends with 1 and proves nothing") {
  pal::MemoryFileSystem files;
  files.add("wrong.pal", "Skill Module: M\nBEGIN\n  WTM( \nEND\n");
  const auto answer = pal::test::pal({"check", "wrong.pal"}, files);
  CHECK(answer.status == ExitStatus::wrong_specification);
  CHECK(answer.err.find("wrong.pal:") != std::string::npos);
}

TEST_CASE("check shows a hundred findings unless told otherwise, and ends the same way") {
  const auto path = std::filesystem::temp_directory_path() / pal::test::own_name("pal_many_errors.pal");
  std::ofstream(path) << [] {
    std::string text;
    for (int i = 0; i < 250; ++i) text += "MESSAGE m" + std::to_string(i) + " : REAL furlong\n";
    return text;
  }();
  const auto shown = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"check", path.string()});
    const auto answer = pal::test::pal(options);
    CHECK(answer.status == ExitStatus::wrong_specification);
    const auto& text = options.back() == "json" ? answer.out : answer.err;
    std::size_t count = 0;
    for (auto at = text.find("is not a unit"); at != std::string::npos;
         at = text.find("is not a unit", at + 1))
      ++count;
    return count;
  };
  CHECK(shown({}) == 100);
  CHECK(shown({"--max-errors", "7"}) == 7);
  CHECK(shown({"--max-errors", "0"}) == 250);
  CHECK(shown({"--emit=tree"}) == 100);
  CHECK(shown({"--format", "json"}) == 250);
  std::filesystem::remove(path);
}

TEST_CASE("the search for loops in no time can be cut short") {
  const std::string golden = std::string(PAL_SOURCE_DIR) + "/tests/golden/codegen/";
  for (const char* most : {"100", "5000", "20000"}) {
    const auto answer = pal::test::pal({"check", golden + "odd_names.pal", "--environment",
                                        golden + "bench.pal", "--skill", "namespace", "--max-states", most});
    INFO(answer.err);
    CHECK(answer.status == ExitStatus::not_met);  // it has no requirement
    CHECK(answer.err.find("PAL0821") == std::string::npos);
  }
}

TEST_CASE("a requirement may name the sets of one value") {
  pal::MemoryFileSystem files;
  files.add("s.pal", R"(
CONDITION c
SKILL s
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
  REQUIREMENT any : INTERVAL OF SPC( c ) AT MOST 1 s
  REQUIREMENT yes : INTERVAL OF SPC( c = TRUE ) AT MOST 1 s
  REQUIREMENT no  : INTERVAL OF SPC( c = FALSE ) IN SM1 AT MOST 1 s
END SKILL
Skill Module: SM1
  ACTIVITY a
BEGIN
  WTM( Coordinator )
  REPEAT
    a
    SPC( c = TRUE )
    a
    SPC( c = FALSE )
    SPC( c = FALSE )
  UNTIL( forever )
END
ENVIRONMENT e
  PROCESSOR P0
  PLACE SM1 ON P0 PRIORITY 1
  TIME a : 5 ms
  COST SET 1 ms
END ENVIRONMENT
)");
  const Answer answer = pal::test::pal({"check", "s.pal", "--format", "json"}, files);
  INFO(answer.out);
  const auto rows = Json::parse(answer.out).at("requirements");
  CHECK(rows.at(0).at("bound_ns") == 6'000'000);
  CHECK(rows.at(1).at("bound_ns") == 13'000'000);
  CHECK(rows.at(2).at("bound_ns") == 12'000'000);
}

namespace {

/// The skill counts 2^bits rounds of 1 ms with its conditions, waits for what comes within 28 ms, 10 ms at a
/// time, and ends. MC1 would answer after that.
std::string counts_and_ends(int bits) {
  std::string conditions, clear, count, end;
  for (int bit = 0; bit <= bits; ++bit) {
    const std::string name = "b" + std::to_string(bit);
    conditions += "CONDITION " + name + "\n";
    clear += "  SPC( " + name + " = FALSE )\n";
    if (bit == bits) break;
    count += "CASE\n( NOT " + name + " ):\nSPC( " + name + " = TRUE )\n( " + name + " ):\nSPC( " + name +
             " = FALSE )\n";
    end += "END CASE\n";
  }
  const std::string last = "b" + std::to_string(bits);
  return "MESSAGE y : SIGNAL\nMESSAGE go : SIGNAL\nMESSAGE late : SIGNAL\nMESSAGE arise : SIGNAL\n"
         "CONDITION came\nDEVICE d1\n" +
         conditions + R"(
SKILL s
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
  REQUIREMENT x : RESPONSE FROM y OF d1 TO w IN MC1 AT MOST 4 ms
  REQUIREMENT i : INTERVAL OF v IN MC1 AT MOST 4 ms
END SKILL
Machine Controller: MC1
  ACTIVITY w
  ACTIVITY v
BEGIN
  TXM( request y from d1 )
  WTM( y from d1 )
  v
  WTM( go from SM1 )
  w
  v
END
Logical Sensor: LS1
  ACTIVITY later
BEGIN
  WTM( arise from SM1 )
  later
  TXM( late to SM1 )
END
Skill Module: SM1
  ACTIVITY a
BEGIN
  WTM( Coordinator )
  SPC( came = FALSE )
)" + clear +
         "  REPEAT\n  a\n" + count + "SPC( " + last + " = TRUE )\n" + end + "UNTIL( " + last + R"( )
  TXM( arise to LS1 )
  REPEAT
    WTM( late from LS1 ) WITHIN 10 ms
      SPC( came = TRUE )
    ELSE
      Do Nothing
    END WTM
  UNTIL( came )
  TXM( go to MC1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT e
  PROCESSOR P0
  PROCESSOR P1
  DEVICE d1 ON REQUEST 1 ms
  PLACE MC1 ON P0 PRIORITY 1
  PLACE SM1 ON P1 PRIORITY 1
  PROCESSOR P2
  PLACE LS1 ON P2 PRIORITY 1
  TIME later : 0 TO 28 ms
  TIME a : 1 ms
  TIME v : 1 ms
  TIME w : 1 ms
END ENVIRONMENT
)";
}

}  // namespace

TEST_CASE("a value that grows until the skill ends breaks nothing") {
  for (const int bits : {3, 8, 10}) {
    pal::MemoryFileSystem files;
    files.add("s.pal", counts_and_ends(bits));
    const Answer answer = pal::test::pal({"check", "s.pal", "--format", "json"}, files);
    INFO(answer.out);
    const auto rows = Json::parse(answer.out).at("requirements");
    REQUIRE(rows.size() == 2);
    CHECK(rows.at(0).at("verdict") == "never");
    CHECK(rows.at(1).at("verdict") == "never");
  }
}

TEST_CASE("the hint for an old sample speaks of samples") {
  std::string text = text_of("two_drivers");
  const std::string before = "REQUIREMENT b : BUSY PERIOD OF P0 AT MOST 50 ms";
  text.replace(text.find(before), before.size(), "REQUIREMENT a : AGE OF y FROM d1 AT w IN MC1 AT MOST 1 ms");
  const auto answer = pal::test::pal({"check", "s.pal"}, in_memory(text));
  INFO(answer.err);
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(answer.err.find("hint: ask for the sample later, or more often, or shorten") != std::string::npos);
}

TEST_CASE("an unknown load has no bound and no excess") {
  const pal::MemoryFileSystem files = in_memory(text_of("unknown_load"));
  for (const std::vector<std::string>& how : {std::vector<std::string>{"--analysis", "compositional"},
                                              {"--analysis", "exact", "--max-states", "5"}}) {
    const auto check = [&](const std::string& format) {
      std::vector<std::string> words{"check", "s.pal", "--format", format};
      words.insert(words.end(), how.begin(), how.end());
      return pal::test::pal(words, files);
    };
    const Answer text = check("text");
    CHECK(text.status == ExitStatus::not_met);
    CHECK(text.out.find("no bound  of    50 %") != std::string::npos);
    CHECK((text.out + text.err).find("too much") == std::string::npos);
    const auto load = nlohmann::json::parse(check("json").out).at("requirements").back();
    CHECK(load.at("bound_ns").is_null());
    CHECK(load.at("verdict") == "undecided");
    CHECK(check("sarif").out.find("has no bound that was found") != std::string::npos);
  }
}

TEST_CASE("a limit of 100 % always holds") {
  std::string all = text_of("unknown_load");
  all.replace(all.find("AT MOST 50 %"), 12, "AT MOST 100 %");
  const Answer answer = pal::test::pal({"check", "s.pal", "--analysis", "compositional"}, in_memory(all));
  CHECK(answer.out.find("<= 100 %  of   100 %  0 % to spare") != std::string::npos);
}

TEST_CASE("two files that do not see each other may have skills and environments of one name") {
  pal::MemoryFileSystem files;
  files.add("a/s.pal", text_of("two_drivers"));
  files.add("b/s.pal", text_of("two_drivers"));
  const Answer apart = pal::test::pal({"check", "a/s.pal", "b/s.pal"}, files);
  INFO(apart.err);
  CHECK(apart.err.find("PAL0205") == std::string::npos);
  // Each is proved in its own environment, and the headings tell them apart.
  std::size_t headings = 0;
  for (std::size_t at = apart.out.find(" (a/s.pal)"); at != std::string::npos;
       at = apart.out.find(" (a/s.pal)", at + 1))
    ++headings;
  CHECK(headings == 1);
  CHECK(apart.out.find(" (b/s.pal)") != std::string::npos);
  files.add("b/s.pal", "USES \"../a/s.pal\"\n" + text_of("two_drivers"));
  CHECK(pal::test::pal({"check", "a/s.pal", "b/s.pal"}, files).err.find("PAL0205") != std::string::npos);
}
