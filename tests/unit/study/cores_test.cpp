#include "study/cores.hpp"

#include <signal.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace pal::study;
namespace fs = std::filesystem;

namespace {

struct Marks {
  std::string folder = (fs::temp_directory_path() / ("pal-cores-" + std::to_string(::getpid()))).string();
  Marks() {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  Marks(const Marks&) = delete;
  Marks& operator=(const Marks&) = delete;
  ~Marks() { fs::remove_all(folder); }

  void set(std::size_t piece) const {
    std::ofstream(folder + "/" + std::to_string(piece), std::ios::app) << ::getpid() << "\n";
  }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
};

}  // namespace

TEST_CASE("each piece is done once, whatever the number of processes") {
  for (const unsigned processes : {1U, 2U, 5U}) {
    const Marks marks;
    std::size_t last = 0;
    const Deaths deaths = run_on_cores({50,
                                        processes,
                                        [&](std::size_t piece) { marks.set(piece); },
                                        [&](std::size_t done) { last = done; },
                                        {}});
    CHECK(deaths.empty());
    CHECK(marks.count() == 50);
    CHECK(last == 50);
  }
  CHECK(run_on_cores({0, 4, [](std::size_t) {}, {}, {}}).empty());
}

TEST_CASE("a process that dies is told of, and the others do the rest") {
  const Marks marks;
  const Deaths deaths = run_on_cores({20,
                                      2,
                                      [&](std::size_t piece) {
                                        if (piece == 3) ::kill(::getpid(), SIGKILL);
                                        marks.set(piece);
                                      },
                                      {},
                                      {}});
  REQUIRE(deaths.size() == 1);
  CHECK(deaths[0] == "by signal 9 (Killed)");
  CHECK(marks.count() == 19);
  CHECK(run_on_cores({1, 1, [](std::size_t) { throw std::bad_alloc(); }, {}, {}}).at(0) ==
        "for lack of memory");
}

TEST_CASE("once it is to stop, no piece is begun") {
  const Marks marks;
  CHECK(run_on_cores({20, 2, [&](std::size_t piece) { marks.set(piece); }, {}, [] { return true; }}).empty());
  CHECK(marks.count() == 0);
}
