// With a courier no profile is lost, without one every second is (thesis, Figures 5.15 and 5.16).
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "runtime/drivers/range_finder/driver.hpp"
#include "runtime/drivers/station.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/devices/range_finder_emulator.hpp"
#include "skills_pal/sensing/edge.hpp"
#include "watch_courier_skill.hpp"
#include "watch_plain_skill.hpp"

namespace pal {
namespace {

using namespace std::chrono_literals;
namespace courier = skills::watch_courier;
namespace plain = skills::watch_plain;

constexpr std::size_t profiles = 20;

/// What the skill saw.
struct Seen {
  std::vector<double> taken;  // ms
  std::vector<double> y, z;   // mm
};

template <class Interface, class Profile, class Edge>
class EdgeSensor final : public Interface {
 public:
  explicit EdgeSensor(Seen& seen) : seen_(seen) {}
  Edge interpret(const Profile& profile) override {
    seen_.taken.push_back(profile.taken);
    const auto found = skills::sensing::find_edge({profile.x, profile.z, profile.valid});
    Edge edge;
    edge.found = found.has_value();
    if (found) {
      edge.y = found->y;
      edge.z = found->z;
      edge.slope = found->beside().angle();
    }
    return edge;
  }

 private:
  Seen& seen_;
};

template <class Interface, class Parameters, class Edge>
class Watcher final : public Interface {
 public:
  explicit Watcher(Seen& seen) : seen_(seen) {}
  void start(const Parameters&) override {}
  bool decide_seen(const Edge& edge) override { return edge.found; }
  void use(const Edge& edge) override {
    seen_.y.push_back(edge.y);
    seen_.z.push_back(edge.z);
  }
  bool decide_watched() override { return seen_.y.size() == profiles; }

 private:
  Seen& seen_;
};

struct StillWorld final : runtime::World {
  void advance_to(runtime::Time) override {}
};

/// A roof whose ridge is at y = 10 mm, 200 mm from the range finder; its sides fall by 30 degrees.
std::optional<double> roof(const Eigen::Vector3d&, const Eigen::Vector3d& ray) {
  const double fall = 1 / std::sqrt(3.0);
  const double side = ray.y() / ray.z() > 0.05 ? fall : -fall;
  return (0.2 - 0.01 * side) / (ray.z() - ray.y() * side);
}

Seen watch(runtime::Skill& skill, Seen& seen, runtime::CostPolicy costs, std::uint64_t seed) {
  StillWorld world;
  runtime::drivers::Station station(world);
  runtime::drivers::Wire wire(station.timeline(), runtime::drivers::range_finder::line);
  sim::RangeFinderEmulator finder(station.timeline(), wire.b(), {[] { return sim::Pose::Identity(); }, roof},
                                  {.seed = seed});
  runtime::drivers::RangeFinderDriver driver(station.timeline(), wire.a());
  station.add(driver);
  runtime::drivers::SessionOptions options;
  options.run = {.costs = costs, .seed = seed};
  const runtime::Outcome outcome = station.run(skill, {}, options);
  INFO(outcome.reason);
  REQUIRE(outcome.code == 0);
  REQUIRE_FALSE(outcome.fault);
  REQUIRE(seen.y.size() == profiles);
  return seen;
}

Seen watch_with_courier(runtime::CostPolicy costs, std::uint64_t seed) {
  Seen seen;
  auto skill = courier::make_watch_courier(
      std::make_unique<Watcher<courier::WatchActivities, courier::Parameters, courier::Edge>>(seen),
      std::make_unique<EdgeSensor<courier::ESActivities, courier::Profile, courier::Edge>>(seen));
  return watch(*skill, seen, costs, seed);
}

Seen watch_without(runtime::CostPolicy costs, std::uint64_t seed) {
  Seen seen;
  auto skill = plain::make_watch_plain(
      std::make_unique<Watcher<plain::WatchActivities, plain::Parameters, plain::Edge>>(seen),
      std::make_unique<EdgeSensor<plain::ESActivities, plain::Profile, plain::Edge>>(seen));
  return watch(*skill, seen, costs, seed);
}

void expect_apart(const std::vector<double>& taken, double apart) {
  REQUIRE(taken.size() >= profiles);
  for (std::size_t i = 1; i < profiles; ++i) CHECK(taken[i] - taken[i - 1] == Approx(apart).margin(0.002));
}

TEST_CASE("range finder: with a courier every profile is used, without one every second") {
  for (const auto costs :
       {runtime::CostPolicy::worst, runtime::CostPolicy::best, runtime::CostPolicy::random}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      expect_apart(watch_with_courier(costs, seed).taken, 78);
      expect_apart(watch_without(costs, seed).taken, 156);
    }
  }
}

TEST_CASE("range finder: an edge goes from bytes to the skill") {
  const Seen seen = watch_with_courier(runtime::CostPolicy::random, 4);
  for (std::size_t i = 0; i < profiles; ++i) {
    CHECK(seen.y[i] == Approx(10).margin(0.15));
    CHECK(seen.z[i] == Approx(200).margin(0.1));
  }
  CHECK(watch_with_courier(runtime::CostPolicy::random, 4).y == seen.y);  // the same seed, the same run
}

}  // namespace
}  // namespace pal
