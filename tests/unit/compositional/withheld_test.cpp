// Shapes of which no bound is given: the document has all of them, and each has a skill whose bound would be
// wrong.
#include "analyzer/compositional/causes/withheld.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <variant>

#include "analyzer/compositional/compositional.hpp"
#include "pal/support/file_system.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::compositional;

namespace {

using Kind = WithheldRow::Kind;

std::string table_of(bool shapes) {
  std::string table =
      "| the verdict says | why there is no bound | what to try instead |\n| --- | --- | --- |\n";
  for (const WithheldRow& row : withheld_rows) {
    if ((row.kind == Kind::shape) != shapes) continue;
    table += "| " + std::string(row.reason) + " | " + std::string(row.why) + " | " +
             std::string(row.advice.empty() ? "–" : row.advice) + " |\n";
  }
  return table;
}

/// Whether a text has the literal parts of a row's reason, one after the other.
bool tells(const std::string& text, std::string_view reason) {
  std::size_t at = 0;
  const auto goes_on = [&](std::string_view part) {
    at = text.find(part, at);
    const bool found = at != std::string::npos;
    at += part.size();
    return found;
  };
  for (auto next = first_placeholder(reason); !next.empty(); next = first_placeholder(reason)) {
    const auto before = static_cast<std::size_t>(next.data() - reason.data());
    if (!goes_on(reason.substr(0, before))) return false;
    reason.remove_prefix(before + next.size());
  }
  return goes_on(reason);
}

/// The one skill of a row.
std::unique_ptr<test::Skill> skill_of(Withheld withheld) {
  auto skill = test::meaningful_skill(
      test::project_file("tests/unit/compositional/withheld/" + std::string(row(withheld).name) + ".pal"));
  REQUIRE(skill->problem->requirements.size() == 1);
  return skill;
}

/// Whether a run goes beyond what is bounded: it has a greater value, or a lesser one, or none at all.
bool beyond(const Verdict& bound, const Witness& witness) {
  const Nanoseconds value = witness.measured.value;
  return witness.failed || (bound.at_least ? value < bound.bound->count() : value > bound.bound->count());
}

}  // namespace

TEST_CASE("compositional.md has what is withheld as the code has it") {
  const auto page = DiskFileSystem().read(PAL_SOURCE_DIR "/docs/internals/compositional.md");
  for (const bool shapes : {true, false}) {
    const std::string table = table_of(shapes);
    INFO("docs/internals/compositional.md lacks this table:\n" << table);
    CHECK(std::get<std::string>(page).find("\n\n" + table + "\n") != std::string::npos);
  }
}

TEST_CASE("without a row of the table a bound comes out that some run exceeds") {
  for (std::size_t i = 0; i < withheld_rows.size(); ++i) {
    const Withheld withheld{static_cast<std::uint8_t>(i)};
    if (row(withheld).kind != Kind::shape) continue;
    CAPTURE(row(withheld).name);
    const auto skill = skill_of(withheld);
    const Verdict none = compositional::analyze(*skill->problem).verdicts.front();
    CAPTURE(none.explanation.text());
    REQUIRE_FALSE(none.bound);
    CHECK(tells(none.explanation.text(), row(withheld).reason));
    const Verdict wrong = compositional::analyze(*skill->problem, {}, false, {withheld}).verdicts.front();
    CAPTURE(wrong.explanation.text());
    REQUIRE(wrong.bound);
    Options options;
    options.max_states = 5'000;
    const Verdict exact = analyze_exactly(*skill->problem, options).verdicts.front();
    CAPTURE(wrong.bound->count(), exact.explanation.text());
    REQUIRE(exact.witness);
    CHECK(beyond(wrong, *exact.witness));
  }
}

TEST_CASE("without a check that only names a gap there is no bound either") {
  for (const Withheld withheld : {Withheld::waits_for_other_job, Withheld::blocks_again}) {
    CAPTURE(row(withheld).name);
    REQUIRE(row(withheld).kind == Kind::gap);
    const auto skill = skill_of(withheld);
    const Verdict none = compositional::analyze(*skill->problem).verdicts.front();
    CAPTURE(none.explanation.text());
    CHECK(tells(none.explanation.text(), row(withheld).reason));
    const Verdict without = compositional::analyze(*skill->problem, {}, false, {withheld}).verdicts.front();
    CAPTURE(without.explanation.text());
    CHECK_FALSE(tells(without.explanation.text(), row(withheld).reason));
    CHECK_FALSE(without.bound);
  }
}
