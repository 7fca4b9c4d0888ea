// Whole blocks of zones are passed over; what is found and forgotten is what one by one would be.
#include "analyzer/zones/known_zones.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <utility>

using namespace pal::analyzer;

namespace {

bool at_least(const Outline& a, const Outline& b) {
  for (std::size_t i = 0; i < a.bounds.size(); ++i) {
    if (a.bounds[i] < b.bounds[i]) return false;
  }
  return a.sum >= b.sum;
}

/// One by one.
struct Plain {
  std::vector<std::pair<int, Outline>> all;

  template <class Includes>
  int first_around(const Outline& outline, const Includes& includes) const {
    for (const auto& [id, known] : all) {
      if (at_least(known, outline) && includes(id)) return id;
    }
    return -1;
  }

  template <class LiesWithin>
  void erase_within(const Outline& outline, const LiesWithin& lies_within) {
    std::erase_if(
        all, [&](const auto& each) { return at_least(outline, each.second) && lies_within(each.first); });
  }

  std::vector<int> ids() const {
    std::vector<int> made;
    for (const auto& [id, known] : all) made.push_back(id);
    return made;
  }
};

}  // namespace

TEST_CASE("known zones are found and removed as by a plain search") {
  std::mt19937 engine(1);
  const auto chance = [&engine](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
  for (int round = 0; round < 30; ++round) {
    const int width = chance(5);
    const int span = 1 + chance(40);
    KnownZones known;
    Plain plain;
    // In two rounds of three the bounds drift, as those of a zone do in which a value grows.
    for (int id = 0; id < 3000; ++id) {
      Outline outline;
      outline.sum = chance(50) + (round % 2 == 0 ? 0 : id / 4);
      for (int i = 0; i < width; ++i) {
        const int drift = round % 3 == 0 ? 0 : i % 2 == 0 ? id / 3 : -id / 3;
        outline.bounds.push_back(chance(span) + drift);
      }
      const int part = chance(7);
      const auto holds = [part](int other) { return (other + part) % 3 != 0; };
      const int found = known.first_around(outline, holds);
      REQUIRE(found == plain.first_around(outline, holds));
      if (found != -1) continue;
      known.erase_within(outline, holds);
      plain.erase_within(outline, holds);
      known.add(id, outline);
      plain.all.emplace_back(id, outline);
    }
    REQUIRE(known.ids() == plain.ids());
  }
}
