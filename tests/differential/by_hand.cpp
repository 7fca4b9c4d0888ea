#include "tests/differential/by_hand.hpp"

#include "analyzer/exact/exact.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/runs/all_runs.hpp"

namespace pal::test {

std::string program(const std::string& name) {
  return project_file("tests/differential/" + name + ".pal");
}

std::string replaced(std::string text, const std::string& part, const std::string& other) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + other.size()))
    text.replace(at, part.size(), other);
  return text;
}

std::int64_t bound(const std::string& text) {
  INFO(text);
  const auto skill = meaningful_skill(text);
  const analyzer::Analysis analysis = analyzer::analyze_exactly(*skill->problem);
  const analyzer::Verdict& verdict = analysis.verdicts.front();
  INFO(verdict.explanation.text());
  CHECK(verdict.exact);
  CHECK(unconfirmed(*skill->problem, analysis) == "");
  CHECK(unexplained(verdict) == "");
  const pan::Network& network = skill->specification.skills.front();
  const pan::Environment& environment = skill->specification.environments.front();
  AllRuns runs(network, environment, wanted(network, environment).front(), Duration(1'000'000), 2000);
  const Seen seen = runs.enumerate(200'000);
  CHECK(seen.complete);
  if (verdict.bound) CHECK(Duration(seen.greatest * 1'000'000) == *verdict.bound);
  return verdict.bound ? verdict.bound->count() / 1'000'000 : -1;
}

}  // namespace pal::test
