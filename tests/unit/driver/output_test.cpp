#include "pal/support/output.hpp"
#include "tests/unit/driver/program.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

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
  CHECK_FALSE(fs::exists(good + ".part"));
  fs::remove_all(folder);
}
