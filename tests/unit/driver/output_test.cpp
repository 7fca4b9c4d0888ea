#include "pal/support/output.hpp"
#include "tests/unit/driver/program.hpp"

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

TEST_CASE("what is no file stays what it is, and is written itself") {
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

TEST_CASE("no file of the user's is in the way of a draft, nor written by way of one") {
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
