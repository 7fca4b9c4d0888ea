// The table of findings: placeholders, their arguments, and the form of its texts.
#include "pal/support/finding.hpp"

#include <catch2/catch.hpp>
#include <cctype>

using namespace pal;

TEST_CASE("a placeholder is a name in braces") {
  static_assert(first_placeholder("there is no {kind} of {node}") == "{kind}");
  static_assert(first_placeholder("write {\"codes\": [0]} or {} for {all}") == "{all}");
  static_assert(first_placeholder("write {\"id\": …} {").empty());
  constexpr FindingRow row{"", Code::PAL0101, "no {a} in {b}", "add {a} to {c}"};
  constexpr Placeholders names = placeholders(row);
  static_assert(names.count == 3 && names.names[0] == "{a}" && names.names[1] == "{b}" &&
                names.names[2] == "{c}");
}

TEST_CASE("arguments stand in the order in which their placeholders are first there") {
  Diagnostics diagnostics;
  const auto& finding =
      diagnostics.report(Finding::nothing_sends_answer, {}, "touch", "ready", std::string("MC1"));
  CHECK(finding.code == Code::PAL0727);
  CHECK(finding.severity == Severity::error);
  CHECK(finding.message == "nothing in skill touch sends ready to MC1");
  CHECK(finding.hint == "add TXM( ready to MC1 ), or name the answer that the skill sends");
  CHECK(finding.finding == Finding::nothing_sends_answer);
  CHECK(finding.arguments == std::vector<std::string>{"touch", "ready", "MC1"});
}

TEST_CASE("an argument with braces is no placeholder, and a number is an argument") {
  CHECK(text_of({Finding::declared_twice, "a {name}", "{what}"}) == "a {name} '{what}' is declared twice");
  CHECK(text_of({Finding::completion_never_sent, 7}) == "nothing sends completion 7");
}

TEST_CASE("one of two findings is told, and told otherwise later") {
  Diagnostics diagnostics;
  auto& finding = diagnostics.report(either<Finding::unexpected, Finding::surplus_word>(false), {}, "'x'");
  CHECK(finding.hint == "remove it");
  finding.say({Finding::misspelt_word, "'x'", "y"});
  CHECK(diagnostics.all().front().message == "unexpected 'x'");
  CHECK(diagnostics.all().front().hint == "did you mean 'y'?");
  finding.suggest("z");
  finding.suggest(std::nullopt);
  CHECK(diagnostics.all().front().hint == "did you mean 'z'?");
}

TEST_CASE("texts and hints are neither empty nor sentences") {
  for (const FindingRow& row : finding_rows) {
    CAPTURE(row.name, row.text, row.hint);
    CHECK_FALSE(row.text.empty());
    for (const std::string_view text : {row.text, row.hint}) {
      if (text.empty()) continue;
      CHECK_FALSE((text.ends_with('.') || text.ends_with(' ') || text.starts_with(' ')));
      // Capitals are words of PAL.
      const bool capital = std::isupper(static_cast<unsigned char>(text[0])) != 0;
      CHECK((!capital || text.size() < 2 || std::isupper(static_cast<unsigned char>(text[1])) != 0));
    }
  }
}
