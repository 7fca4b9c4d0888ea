#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "pal/support/line_difference.hpp"
#include "tests/unit/program/program.hpp"

using pal::MemoryFileSystem;
using pal::program::ExitStatus;

namespace {

namespace fs = std::filesystem;

const std::string tidy = "MESSAGE tick : SIGNAL\n";
const std::string untidy = "message tick:signal # comes\n";
const std::string wrong = "MESSAGE tick SIGNAL\n";

/// A folder of real files that is removed at the end.
class FormatFolder {
 public:
  FormatFolder() : path_(fs::temp_directory_path() / pal::test::own_name("pal-format-test")) {
    fs::remove_all(path_);
    fs::create_directories(path_ / ".hidden");
  }
  ~FormatFolder() { fs::remove_all(path_); }
  std::string add(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }
  std::string text(const std::string& name) const {
    return std::get<std::string>(pal::DiskFileSystem().read((path_ / name).string()));
  }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("fmt writes in place what is not in canonical layout, in folders too") {
  const FormatFolder folder;
  const auto a = folder.add("a.pal", untidy);
  const auto b = folder.add("b.pal", tidy);
  folder.add(".hidden/c.pal", untidy);
  folder.add("d.txt", untidy);
  fs::permissions(a, fs::perms::owner_all);
  fs::create_symlink("a.pal", folder.path() + "/link.pal");

  const auto answer = pal::test::pal({"fmt", folder.path(), a});
  CHECK(answer.status == ExitStatus::all_hold);
  CHECK(answer.out.find(a + "\n") == 0);
  CHECK(folder.text("a.pal") == "MESSAGE tick : SIGNAL  # comes\n");
  CHECK(fs::status(a).permissions() == fs::perms::owner_all);
  CHECK(fs::is_symlink(folder.path() + "/link.pal"));
  CHECK(folder.text(".hidden/c.pal") == untidy);
  CHECK(folder.text("d.txt") == untidy);
  CHECK(pal::test::pal({"fmt", "--check", folder.path()}).status == ExitStatus::all_hold);
}

TEST_CASE("fmt leaves a file with syntax errors alone, and says what is wrong") {
  const FormatFolder folder;
  const auto a = folder.add("a.pal", wrong);
  const auto b = folder.add("b.pal", untidy);
  const auto answer = pal::test::pal({"fmt", a, b});
  CHECK(answer.status == ExitStatus::wrong_specification);
  CHECK(answer.err.find("a.pal:1:14") != std::string::npos);
  CHECK(folder.text("a.pal") == wrong);
  CHECK(folder.text("b.pal") != untidy);
}

TEST_CASE("fmt --check lists what would change, and shows how") {
  const MemoryFileSystem files({{"a.pal", untidy}, {"b.pal", tidy}});
  const auto listed = pal::test::pal({"fmt", "--check", "a.pal", "b.pal"}, files);
  CHECK(listed.status == ExitStatus::wrong_specification);
  CHECK(listed.out == "a.pal\n");
  const auto shown = pal::test::pal({"fmt", "--check", "--diff", "a.pal", "b.pal"}, files);
  CHECK(shown.status == ExitStatus::wrong_specification);
  CHECK(shown.out ==
        "--- a.pal\n+++ a.pal (formatted)\n@@ -1,1 +1,1 @@\n-message tick:signal # comes\n+MESSAGE tick : "
        "SIGNAL  # comes\n");
  CHECK(pal::test::pal({"fmt", "--diff", "a.pal"}, files).status == ExitStatus::usage);
}

TEST_CASE("fmt - goes from standard input to standard output") {
  const MemoryFileSystem files({{"/dev/stdin", untidy}});
  CHECK(pal::test::pal({"fmt", "-"}, files).out == "MESSAGE tick : SIGNAL  # comes\n");
  CHECK(pal::test::pal({"fmt", "-", "--check"}, files).status == ExitStatus::wrong_specification);
  CHECK(pal::test::pal({"fmt", "none.pal"}, files).status == ExitStatus::usage);
  CHECK(pal::test::pal({"fmt", "-"}, MemoryFileSystem({{"/dev/stdin", std::string("\0", 1)}})).status ==
        ExitStatus::wrong_specification);
}

TEST_CASE("a difference shows the changed lines and three around them") {
  std::string before;
  for (int i = 1; i <= 20; ++i) before += std::to_string(i) + "\n";
  auto after = before;
  after.replace(after.find("2\n"), 2, "two\n");
  after.replace(after.find("18\n"), 3, "");
  after += "end";
  CHECK(pal::line_difference("a", before, "b", after) ==
        "--- a\n+++ b\n"
        "@@ -1,5 +1,5 @@\n 1\n-2\n+two\n 3\n 4\n 5\n"
        "@@ -15,6 +15,6 @@\n 15\n 16\n 17\n-18\n 19\n 20\n+end\n\\ No newline at end of file\n");
  CHECK(pal::line_difference("a", "", "b", "x\n") == "--- a\n+++ b\n@@ -0,0 +1,1 @@\n+x\n");
  CHECK(pal::line_difference("a", "x\n", "b", "") == "--- a\n+++ b\n@@ -1,1 +0,0 @@\n-x\n");
  CHECK(pal::line_difference("a", before, "b", before).empty());
}
