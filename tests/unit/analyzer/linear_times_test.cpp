#include "analyzer/runs/linear_times.hpp"

#include <unistd.h>

#include <algorithm>
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

/// Instants at 0 or 1, and four sums of them that must be met exactly: it takes far longer than any user
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

TEST_CASE("the search for times ends when it is stopped") {
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

TEST_CASE("a signal during the search for times reaches the thread that waits for it") {
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

/// An action that is interrupted a number of times. Each of its pieces, and each interruption, takes up to 2;
/// the pieces come to `worked` in all.
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

TEST_CASE("an action that was interrupted a hundred times has worked for the time required") {
  const Interrupted action(100, 125);
  const auto times = linear_times(action.count, action.differences, {action.work}, Goal{0, 200});
  REQUIRE(times);
  Nanoseconds worked = 0;
  for (const auto& [begin, end] : action.work.pieces) worked += (*times)[end] - (*times)[begin];
  CHECK(worked == 125);
  CHECK(times->back() == 325);
}

TEST_CASE("the search for times of too many events gives up at once") {
  const Interrupted action(4000, 5000);
  const auto begin = Clock::now();
  CHECK_FALSE(linear_times(action.count, action.differences, {action.work}, Goal{0, 8000}));
  CHECK(milliseconds_since(begin) < 1500);
}

namespace {

/// Few times, none of them above 6, that some differences and sums of pieces hold together.
struct Drawn {
  static constexpr std::size_t count = 4;
  std::vector<Difference> differences;
  std::vector<Work> works;
  Goal goal;

  explicit Drawn(std::mt19937_64& engine) {
    const auto any = [&engine](std::size_t below) { return static_cast<std::size_t>(engine() % below); };
    for (std::size_t i = 1; i < count; ++i) {
      differences.push_back({0, i, 6});
      differences.push_back({i, 0, 0});
      differences.push_back({any(count), i, static_cast<Nanoseconds>(any(7)) - 1});
    }
    for (int i = 0; i < 2; ++i) {
      const auto least = static_cast<Nanoseconds>(any(3));
      works.push_back({{{0, any(count)}, {any(count), 1}, {any(count), any(count)}}, {least, least + 2}});
    }
    goal = {any(count), 1 + any(count - 1)};
    if (any(2) == 0) goal.enough = static_cast<Nanoseconds>(any(8)) - 1;
  }

  Nanoseconds value(const std::vector<Nanoseconds>& times) const { return times[goal.to] - times[goal.from]; }

  bool keeps(const std::vector<Nanoseconds>& times) const {
    for (const Difference& each : differences)
      if (times[each.to] - times[each.from] > each.bound) return false;
    for (const Work& work : works) {
      Nanoseconds sum = 0;
      for (const auto& [begin, end] : work.pieces) sum += times[end] - times[begin];
      if (sum < work.range.best || sum > work.range.worst) return false;
    }
    return true;
  }

  std::optional<Nanoseconds> greatest() const {
    std::optional<Nanoseconds> most;
    for (int code = 0; code < 7 * 7 * 7; ++code) {
      const std::vector<Nanoseconds> times{0, code % 7, code / 7 % 7, code / 49};
      if (keeps(times)) most = std::max(most.value_or(value(times)), value(times));
    }
    return most;
  }
};

}  // namespace

TEST_CASE("the greatest difference is that of all possible times") {
  std::mt19937_64 engine(3);
  int some = 0;
  for (int round = 0; round < 400; ++round) {
    const Drawn drawn(engine);
    const auto most = drawn.greatest();
    const auto times = linear_times(Drawn::count, drawn.differences, drawn.works, drawn.goal);
    CAPTURE(round);
    REQUIRE(times.has_value() == most.has_value());
    if (!times) continue;
    ++some;
    CHECK(drawn.keeps(*times));
    CHECK(drawn.value(*times) >= std::min(*most, drawn.goal.enough));
  }
  CHECK(some > 100);
}

TEST_CASE("an unbounded difference has no greatest value") {
  CHECK_FALSE(linear_times(2, {{1, 0, 0}}, {}, Goal{0, 1}));
  const auto enough = linear_times(2, {{1, 0, 0}}, {}, Goal{0, 1, 100});
  REQUIRE(enough);
  CHECK(enough->back() >= 100);
}

TEST_CASE("a stopped search has the greatest difference that it found until then") {
  const Interrupted action(100, 125);
  std::size_t found = 0;
  for (int wait = 2; wait < 60; wait += 2) {
    const auto begin = Clock::now();
    const auto stop = [begin, wait] { return milliseconds_since(begin) >= wait; };
    const auto times = linear_times(action.count, action.differences, {action.work}, Goal{0, 200}, stop);
    if (!times) continue;
    ++found;
    Nanoseconds worked = 0;
    for (const auto& [from, to] : action.work.pieces) worked += (*times)[to] - (*times)[from];
    CHECK(worked == 125);
  }
  CHECK(found > 0);
}
