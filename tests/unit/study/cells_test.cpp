#include "study/cells.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace pal::study;

namespace {

Study study_of(const std::vector<std::size_t>& sizes) {
  Study study;
  for (const std::size_t size : sizes) {
    Figure figure{"f" + std::to_string(study.figures.size()), {}, 0};
    for (std::size_t i = 0; i < size; ++i)
      figure.choices.push_back({std::to_string(i), {figure.name + " = " + std::to_string(i)}});
    study.figures.push_back(std::move(figure));
  }
  return study;
}

}  // namespace

TEST_CASE("each combination has one number") {
  const Study study = study_of({2, 3, 4});
  REQUIRE(count_points(study) == 24);
  std::set<std::vector<std::size_t>> seen;
  for (std::uint64_t point = 0; point < 24; ++point) seen.insert(choices_at(study, point));
  CHECK(seen.size() == 24);
  CHECK(choices_at(study, 1) == std::vector<std::size_t>{0, 0, 1});
  CHECK(changes_of(study, {1, 0, 3}) == std::vector<std::string>{"f0 = 1", "f1 = 0", "f2 = 3"});
  CHECK(count_points(Study{}) == 1);
}

TEST_CASE("combinations that no 64 bits count are not counted") {
  CHECK(count_points(study_of({100'000, 100'000, 100'000})) == 1'000'000'000'000'000);
  CHECK_FALSE(count_points(study_of({100'000, 100'000, 100'000, 100'000})));
}
