#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "tests/unit/program/program.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal::test;
using pal::program::ExitStatus;
namespace fs = std::filesystem;

namespace {

class StudyFolder {
 public:
  StudyFolder() { fs::remove_all(path); }
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;
  ~StudyFolder() { fs::remove_all(path); }

  std::string read(const std::string& name) const {
    std::ifstream file(path + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::vector<fs::path> proofs(const std::string& below = "/proofs") const {
    std::vector<fs::path> found;
    for (const auto& each : fs::recursive_directory_iterator(path + below))
      if (each.is_regular_file()) found.push_back(each.path());
    return found;
  }

  const std::string path = (fs::temp_directory_path() / own_name("pal-sweep")).string();
};

const std::string figures = R"(
[[figure]]
name = "heavy OF LS1"
values = ["1 ms", "5 ms", "8 ms"]
[[figure]]
name = "MC1.period"
values = ["0 ms", "5 ms", "10 ms"]
[[figure]]
name = "SM1.priority"
values = [1, 3]
)";

pal::MemoryFileSystem files_with(const std::string& study, const std::string& limit = "6 ms") {
  pal::MemoryFileSystem files = in_memory(two_chains(limit));
  files.add("study.toml", study);
  return files;
}

const std::string named = "files = [\"s.pal\"]\n";

Answer sweep(const StudyFolder& folder, const std::string& study, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"sweep", "study.toml", "-o", folder.path};
  words.insert(words.end(), more.begin(), more.end());
  return pal::test::pal(words, files_with(study));
}

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const auto at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), now);
}

/// Without the seconds that a case of JUnit took.
std::string untimed(const std::string& text) {
  return std::regex_replace(text, std::regex(" time=\"[0-9.]+\""), "");
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void refused(const std::string& study, const std::string& why) {
  const StudyFolder folder;
  const Answer answer = sweep(folder, study);
  INFO(answer.err);
  CHECK(answer.status == ExitStatus::usage);
  CHECK(has(answer.err, why));
  CHECK_FALSE(fs::exists(folder.path));
}

}  // namespace

TEST_CASE("a study says of each cell what check says of the same text") {
  const StudyFolder folder;
  const Answer answer = sweep(folder, named + figures);
  INFO(answer.err);
  REQUIRE(answer.status == ExitStatus::all_hold);
  const auto rows = nlohmann::json::parse(folder.read("table.json")).at("rows");
  REQUIRE(rows.size() == 18);
  std::map<std::string, int> seen;
  for (const auto& row : rows) {
    const auto& values = row.at("values");
    std::string text = two_chains("6 ms");
    text = replaced(text, "heavy OF LS1 : 5 ms", "heavy OF LS1 : " + values.at(0).get<std::string>());
    text = replaced(text, "tick EVERY 10 ms", "tick EVERY " + values.at(1).get<std::string>());
    text = replaced(text, "SM1 ON P0 PRIORITY 1", "SM1 ON P0 PRIORITY " + values.at(2).get<std::string>());
    const Answer check = pal::test::pal({"check", "s.pal", "--format", "json"}, in_memory(text));
    const auto told = nlohmann::json::parse(check.out).at("requirements").at(0);
    INFO(row.dump() << "\n" << told.dump());
    for (const char* key : {"verdict", "limit_ns", "bound_ns", "attained_ns", "exact", "measure"})
      CHECK(row.at(key) == told.at(key));
    ++seen[row.at("verdict").get<std::string>()];
    if (values.at(1) == "0 ms") CHECK(has(row.at("note").get<std::string>(), "PAL0708"));
  }
  CHECK(seen == std::map<std::string, int>{{"fails", 4}, {"holds", 8}, {"not checked", 6}});
}

TEST_CASE("a study is the same on one process and on more, fresh or kept, byte for byte") {
  const StudyFolder folder;
  REQUIRE(sweep(folder, named + figures, {"--jobs", "1"}).status == ExitStatus::all_hold);
  std::map<std::string, std::string> first;
  for (const char* name :
       {"table.csv", "table.json", "summary.md", "map-of-heavy-OF-LS1-and-MC1.period.svg"}) {
    first[name] = folder.read(name);
    CHECK_FALSE(first[name].empty());
  }
  const Answer again = sweep(folder, named + figures);
  CHECK(has(again.err, "18 proofs, 18 of them made before"));
  for (const auto& [name, text] : first) CHECK(folder.read(name) == text);
  fs::remove_all(folder.path);
  const Answer more = sweep(folder, named + figures, {"--jobs", "3"});
  CHECK(has(more.err, "18 proofs, 0 of them made before"));
  for (const auto& [name, text] : first) CHECK(folder.read(name) == text);
}

TEST_CASE("a study that has some of its proofs makes the others alone") {
  const StudyFolder folder;
  REQUIRE(sweep(folder, named + figures, {"--cells", "0..6"}).status != ExitStatus::usage);
  CHECK_FALSE(fs::exists(folder.path + "/table.csv"));
  const Answer answer = sweep(folder, named + figures);
  CHECK(has(answer.err, "18 proofs, 7 of them made before"));
  CHECK(answer.status == ExitStatus::all_hold);
}

TEST_CASE("a kept proof that was cut off is noticed and made again") {
  const StudyFolder folder;
  REQUIRE(sweep(folder, named + figures).status == ExitStatus::all_hold);
  const std::string table = folder.read("table.csv");
  const auto proofs = folder.proofs();
  REQUIRE(proofs.size() == 18);
  fs::resize_file(proofs[0], fs::file_size(proofs[0]) / 2);
  const Answer answer = sweep(folder, named + figures);
  CHECK(has(answer.err, "1 kept proofs were damaged, and were made again"));
  CHECK(folder.read("table.csv") == table);
  CHECK_FALSE(has(sweep(folder, named + figures).err, "damaged"));
}

TEST_CASE("what makes no sense is told before anything runs") {
  refused(named + "[[figure]]\nname = \"hevy OF LS1\"\nvalues = [\"1 ms\"]\n",
          "pal: study.toml:2: figure 'hevy OF LS1': environment cell gives no figure for 'hevy OF LS1'");
  refused(named + "[[figure]]\nname = \"heavy OF LS1\"\nfrom = \"2 ms\"\nto = \"1 ms\"\nstep = \"1 ms\"\n",
          "pal: study.toml:2: figure 'heavy OF LS1': the range is empty: it goes from 2 ms to 1 ms");
  const std::string thousand = "from = 1\nto = 1000\nstep = 1\n";
  refused(named + "[[figure]]\nname = \"SM1.priority\"\n" + thousand +
              "[[figure]]\nname = \"LS1.priority\"\n" + thousand +
              "[[figure]]\nname = \"x\"\nset = [\"SM1.priority = {}\"]\n" + thousand,
          "the study has 1 000 000 000 proofs, 1 000 of SM1.priority x 1 000 of LS1.priority x 1 000 of x; "
          "at most 1 "
          "000 000 are begun");
  refused(named + "skills = [\"t\"]\n", "no skill is called 't'; there is 's'");
  refused(named + "requirements = [\"son\"]\n", "no skill has a requirement 'son'; there is 'soon'");
  refused("files = [\"s.pal\"]\n[[figure]]\nname = \"SM1.processor\"\nvalues = [\"P0\"]\nfoo = 1\n",
          "study.toml:5: a figure has no 'foo'");
  expect_refused({"sweep", "there-is-no.toml"}, "cannot read 'there-is-no.toml'");
}

TEST_CASE("a parameter of a skill is no figure, because no proof depends on it") {
  const StudyFolder folder;
  pal::MemoryFileSystem files;
  files.add("s.pal", replaced(two_chains("6 ms"), "  COMPLETION 0",
                              "  PARAMETER speed : REAL mm/s DEFAULT 2 RANGE 1 TO 3 \"x\"\n  COMPLETION 0"));
  files.add("study.toml", named + "[[figure]]\nname = \"s.speed\"\nvalues = [1, 2]\n");
  const Answer answer = pal::test::pal({"sweep", "study.toml", "-o", folder.path}, files);
  CHECK(answer.status == ExitStatus::usage);
  CHECK(has(answer.err, "figure 's.speed' is a parameter of skill s, and no proof depends on it"));
}

TEST_CASE("the exit status of a study, and its count") {
  const StudyFolder folder;
  CHECK(sweep(folder, named + figures, {"--count"}).out ==
        "18 proofs: 18 points, 1 skills and environments\n");
  CHECK(sweep(folder, named + figures, {"--all-hold"}).status == ExitStatus::not_met);
  const std::string good = named + "[[figure]]\nname = \"heavy OF LS1\"\nvalues = [\"1 ms\"]\n";
  CHECK(sweep(folder, good, {"--all-hold"}).status == ExitStatus::all_hold);
  CHECK(has(folder.read("slack-over-heavy-OF-LS1.svg"), "s in cell"));
}

TEST_CASE("a limit of time leaves a proof undecided, and says so") {
  const StudyFolder folder;
  const std::string study =
      named + "[limits]\ntimeout = \"1 ns\"\n[[figure]]\nname = \"heavy OF LS1\"\nvalues = [\"5 ms\"]\n";
  const Answer answer = sweep(folder, study, {"--all-hold"});
  CHECK(answer.status == ExitStatus::not_met);
  CHECK(has(folder.read("table.csv"), "undecided"));
  CHECK(has(folder.read("table.csv"), "the study's limit of time, or of memory, ended the proof"));
  // Another limit is another proof.
  CHECK(sweep(folder, replaced(study, "1 ns", "60 s")).status == ExitStatus::all_hold);
  CHECK(has(folder.read("table.csv"), "fails"));
}

TEST_CASE("the worst run of each failure is a chart") {
  const StudyFolder folder;
  const Answer answer = sweep(folder, named + figures, {"--worst-runs"});
  CHECK(has(answer.out, "4 worst runs of 4 failures drawn in " + folder.path + "/worst"));
  CHECK(folder.proofs("/worst").size() == 4);
  CHECK(has(folder.read("worst/14.s.cell.soon.svg"), "<svg"));
}

TEST_CASE("an interrupted study keeps what it has, and goes on from there") {
  const StudyFolder folder;
  const std::string study =
      named + "[[figure]]\nname = \"heavy OF LS1\"\nfrom = \"1 us\"\nto = \"3 ms\"\nstep = \"1 us\"\n";
  const pid_t child = ::fork();
  if (child == 0) ::_exit(static_cast<int>(sweep(folder, study, {"--jobs", "2"}).status));
  REQUIRE(child > 0);
  for (int i = 0; i < 500 && (!fs::exists(folder.path + "/proofs") || folder.proofs().size() < 5); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == static_cast<int>(ExitStatus::not_met));
  CHECK_FALSE(fs::exists(folder.path + "/table.csv"));
  const std::size_t kept = folder.proofs().size();
  CHECK(kept >= 5);
  CHECK(kept < 3000);
  const Answer rest = sweep(folder, study, {"--cells", "0..20"});
  CHECK(rest.status == ExitStatus::all_hold);
}

TEST_CASE("check takes proofs from a cache, and says the same as without") {
  const StudyFolder folder;
  const auto check = [&](const std::string& text, std::vector<std::string> more) {
    std::vector<std::string> words{"check", "s.pal"};
    words.insert(words.end(), more.begin(), more.end());
    Answer answer = pal::test::pal(words, in_memory(text));
    answer.out = std::regex_replace(answer.out, std::regex(R"( time="[0-9.]+")"), "");  // that it took
    return answer;
  };
  const std::string good = two_chains("9 ms"), late = two_chains("6 ms");
  const std::vector<std::string> cache{"--cache", folder.path};
  for (const std::string& text : {good, late}) {
    for (const std::vector<std::string>& form : {std::vector<std::string>{},
                                                 {"--format", "json"},
                                                 {"--explain"},
                                                 {"--format", "sarif"},
                                                 {"--format", "junit"}}) {
      std::vector<std::string> with = form;
      with.insert(with.end(), cache.begin(), cache.end());
      const Answer plain = check(text, form), first = check(text, with), second = check(text, with);
      INFO(second.err);
      CHECK(untimed(first.out) == untimed(plain.out));
      CHECK(untimed(second.out) == untimed(plain.out));
      CHECK(first.status == plain.status);
      CHECK(second.status == plain.status);
      CHECK(has(second.err, text == good ? "1 of 1 proofs were kept ones" : "0 of 1 proofs were kept ones"));
    }
  }
  // Lines move: verdicts stay, and the lines that addends name are those of now.
  const std::string moved = "# a comment\n" + good;
  CHECK(has(check(moved, cache).err, "1 of 1 proofs were kept ones"));
  const Answer explained = check(moved, {"--explain", "--cache", folder.path});
  CHECK(has(explained.err, "0 of 1"));
  CHECK(explained.out == check(moved, {"--explain"}).out);
  // A study takes them, too.
  pal::MemoryFileSystem files = in_memory(good);
  files.add("study.toml", named);
  const Answer study =
      pal::test::pal({"sweep", "study.toml", "-o", folder.path + "/s", "--cache", folder.path}, files);
  CHECK(has(study.err, "1 proofs, 1 of them made before"));
}

TEST_CASE("check does not take damaged proofs, and keeps none that a limit ended") {
  const StudyFolder folder;
  const pal::MemoryFileSystem files = in_memory(two_chains("9 ms"));
  const std::vector<std::string> words{"check", "s.pal", "--cache", folder.path};
  REQUIRE(pal::test::pal({"check", "s.pal", "--cache", folder.path, "--timeout", "1ns"}, files).status ==
          ExitStatus::not_met);
  CHECK_FALSE(fs::exists(folder.path));
  REQUIRE(pal::test::pal(words, files).status == ExitStatus::all_hold);
  REQUIRE(folder.proofs("").size() == 1);
  fs::resize_file(folder.proofs("")[0], 100);
  const Answer answer = pal::test::pal(words, files);
  CHECK(has(answer.err, "1 kept proofs were damaged, and were made again"));
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(has(pal::test::pal(words, files).err, "1 of 1 proofs were kept ones"));
}
