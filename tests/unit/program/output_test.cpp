#include "pal/support/output.hpp"
#include "tests/unit/program/program.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

TEST_CASE("files are written whole or not at all") {
  const fs::path folder = fs::temp_directory_path() / pal::test::own_name("pal-output-test");
  fs::remove_all(folder);
  const std::string good = (folder / "a" / "good.txt").string();
  CHECK_FALSE(pal::write_files({{good, "one"}}));
  CHECK(fs::file_size(good) == 3);

  // The second cannot be written, so the first stays as it was.
  fs::create_directories(folder / "taken");
  const auto problem = pal::write_files({{good, "three"}, {(folder / "taken").string(), "x"}});
  REQUIRE(problem);
  CHECK(problem->find("taken") != std::string::npos);
  CHECK(fs::file_size(good) == 3);
  CHECK(std::distance(fs::directory_iterator(folder / "a"), fs::directory_iterator()) == 1);
  fs::remove_all(folder);
}

TEST_CASE("a pipe or device is written directly and stays what it is") {
  const fs::path folder = fs::temp_directory_path() / pal::test::own_name("pal-output-to-a-pipe");
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string pipe = (folder / "pipe").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const std::string file = (folder / "file").string();
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  CHECK_FALSE(pal::write_files({{pipe, "through the pipe"}, {file, "to the file"}}));
  char read_back[32] = {};
  CHECK(read(reader, read_back, sizeof read_back - 1) == 16);
  close(reader);
  CHECK(std::string(read_back) == "through the pipe");
  CHECK(fs::is_fifo(pipe));
  CHECK(fs::file_size(file) == 11);
  fs::remove_all(folder);
}

TEST_CASE("drafts never collide with files of the user") {
  const fs::path folder = fs::temp_directory_path() / pal::test::own_name("pal-output-drafts");
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string target = (folder / "a.json").string();
  std::ofstream(target + ".part") << "mine";
  CHECK_FALSE(pal::write_files({{target, "content"}}));
  CHECK(fs::file_size(target + ".part") == 4);
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 2);

  const auto twice = pal::write_files({{target, "one"}, {target, "the other"}});
  REQUIRE(twice);
  CHECK(twice->find("two files") != std::string::npos);
  CHECK(fs::file_size(target) == 7);
  fs::remove_all(folder);
}

namespace {

/// A folder of its own with the skill touch in it, and links to it.
struct OutputFolder {
  OutputFolder() {
    fs::remove_all(path);
    fs::create_directories(path);
    fs::copy_file(pal::test::skill("workcell.pal"), cell);
    fs::create_symlink(cell, link);
    fs::create_hard_link(cell, hard);
  }
  ~OutputFolder() { fs::remove_all(path); }
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  fs::path path = fs::temp_directory_path() / pal::test::own_name("pal-inputs-and-outputs");
  std::string cell = (path / "cell.pal").string();
  std::string link = (path / "link").string();
  std::string hard = (path / "hard.svg").string();
};

}  // namespace

TEST_CASE("no command overwrites its input, or writes anything but PAL to a .pal file") {
  const OutputFolder folder;
  const auto size = fs::file_size(folder.cell);
  const std::string touch = pal::test::skill("touch/touch.pal");
  const std::string runs = (folder.path / "runs.json").string();
  const std::string picture = (folder.path / "picture.svg").string();
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    for (const char* more : {touch.c_str(), "-e", folder.cell.c_str()}) arguments.emplace_back(more);
    const pal::test::Answer answer = pal::test::pal(arguments);
    INFO(answer.err);
    CHECK(answer.status == pal::program::ExitStatus::usage);
    CHECK(answer.out.empty());
    CHECK(answer.err.find(why) != std::string::npos);
    CHECK(fs::file_size(folder.cell) == size);
  };
  const std::string was_read = "it is one of the files that were read";
  for (const std::string& input : {folder.cell, folder.link, folder.hard}) {
    refused({"check", "--witness", input}, "cannot write " + input + ": " + was_read);
    refused({"atc", "-o", input}, was_read);
    refused({"atc", "-o", picture, "--trace", input}, was_read);
    refused({"simulate", "--runs", "1", "--trace", input}, was_read);
    refused({"simulate", "--runs", "1", "--chart", input}, was_read);
    refused({"whatif", "--place", "1", "--witness", input}, was_read);
    refused({"generate", "-o", folder.path.string(), "--depfile", input}, was_read);
  }
  const std::string other = (folder.path / "other.pal").string();
  refused({"check", "--witness", other},
          "cannot write " + other + ": a name that ends in .pal is for PAL files");
  refused({"atc", "-o", other}, "a name that ends in .pal is for PAL files");
  CHECK_FALSE(fs::exists(other));
  CHECK(pal::test::pal({"doc", touch, "-o", other}).status == pal::program::ExitStatus::usage);

  CHECK(pal::test::pal({"check", touch, "-e", folder.cell, "--witness", runs}).status ==
        pal::program::ExitStatus::all_hold);
  refused({"simulate", "--script", runs, "--trace", runs}, was_read);
}

TEST_CASE("a file is read once, under whatever names it is given") {
  const OutputFolder folder;
  const std::string touch = pal::test::skill("touch/touch.pal");
  for (const std::string& again : {folder.cell, folder.link, folder.hard,
                                   (folder.path / ".." / folder.path.filename() / "cell.pal").string()}) {
    const pal::test::Answer answer = pal::test::pal({"check", touch, "-e", folder.cell, "-e", again});
    INFO(answer.err);
    CHECK(answer.status == pal::program::ExitStatus::all_hold);
    CHECK(answer.err.empty());
  }
}
