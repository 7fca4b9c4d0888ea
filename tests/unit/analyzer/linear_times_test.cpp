#include "analyzer/runs/linear_times.hpp"

#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

using namespace pal::analyzer;

namespace {

using Clock = std::chrono::steady_clock;

std::int64_t milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin).count();
}

/// Instants at 0 or 1, and four sums of them that must be met exactly: it takes far longer than anybody
/// waits (a market split, G. Cornuejols and M. Dawande, A class of hard small 0-1 programs, 1999).
struct Hard {
  static constexpr std::size_t count = 25;
  std::vector<Difference> differences;
  std::vector<Work> works;

  Hard() {
    std::mt19937_64 engine(7);
    for (std::size_t i = 1; i < count; ++i) {
      differences.push_back({0, i, 1});
      differences.push_back({i, 0, 0});
    }
    for (int sum = 0; sum < 4; ++sum) {
      Work work;
      for (std::size_t i = 1; i < count; ++i) work.pieces.insert(work.pieces.end(), engine() % 20, {0, i});
      const auto half = static_cast<Nanoseconds>(work.pieces.size() / 2);
      work.range = {half, half};
      works.push_back(std::move(work));
    }
  }
};

volatile std::sig_atomic_t signalled = 0;

}  // namespace

TEST_CASE("the search for times ends when it is told to") {
  const Hard hard;
  const auto begin = Clock::now();
  const auto stop = [begin] { return milliseconds_since(begin) > 100; };
  CHECK_FALSE(linear_times(Hard::count, hard.differences, hard.works, {}, stop));
  CHECK(milliseconds_since(begin) < 1500);
  // What comes afterwards is not hurt by it.
  const auto after = linear_times(2, {{0, 1, 5}}, {}, Goal{0, 1}, [] { return false; });
  REQUIRE(after);
  CHECK(after->back() == 5);
}

TEST_CASE("a signal during the search for times reaches whoever waits for it") {
  const Hard hard;
  signalled = 0;
  const auto before = std::signal(SIGINT, [](int) { signalled = 1; });
  std::atomic<bool> over = false;
  std::thread sender([&over] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    if (!over) kill(getpid(), SIGINT);
  });
  const auto stop = [] { return signalled != 0; };
  CHECK_FALSE(linear_times(Hard::count, hard.differences, hard.works, {}, stop));
  over = true;
  sender.join();
  std::signal(SIGINT, before);
  CHECK(signalled == 1);
}

namespace {

/// An action that is interrupted so many times. Each of its pieces, and each interruption, takes up to 2; the
/// pieces come to `worked` in all.
struct Interrupted {
  std::vector<Difference> differences;
  Work work;
  std::size_t count;

  Interrupted(std::size_t pieces, Nanoseconds worked) : count(2 * pieces + 1) {
    work.range = {worked, worked};
    for (std::size_t i = 0; i < 2 * pieces; ++i) {
      differences.push_back({i, i + 1, 2});
      differences.push_back({i + 1, i, 0});
      if (i % 2 == 0) work.pieces.emplace_back(i, i + 1);
    }
  }
};

}  // namespace

TEST_CASE("an action that was interrupted a hundred times has worked as long as it must") {
  const Interrupted action(100, 125);
  const auto times = linear_times(action.count, action.differences, {action.work}, Goal{0, 200});
  REQUIRE(times);
  Nanoseconds worked = 0;
  for (const auto& [begin, end] : action.work.pieces) worked += (*times)[end] - (*times)[begin];
  CHECK(worked == 125);
  CHECK(times->back() == 325);
}

TEST_CASE("times of more events than can be looked for in time are given up at once") {
  const Interrupted action(4000, 5000);
  const auto begin = Clock::now();
  CHECK_FALSE(linear_times(action.count, action.differences, {action.work}, Goal{0, 8000}));
  CHECK(milliseconds_since(begin) < 1500);
}
