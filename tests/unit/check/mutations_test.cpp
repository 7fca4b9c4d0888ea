// What happens to a right program with one thing wrong.
#include <catch2/catch.hpp>
#include <cctype>
#include <random>
#include <string>
#include <vector>

#include "pal/support/diagnostic_code.hpp"
#include "tests/support/touch_files.hpp"
#include "tests/unit/check/specification.hpp"

using namespace pal;

namespace {

/// The words of a text as [begin, end), comments left out: enough of PAL's lexer to take words away.
std::vector<std::pair<std::size_t, std::size_t>> words(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  const auto in_name = [&](std::size_t i) {
    return i < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '-' || text[i] == '_');
  };
  for (std::size_t i = 0; i < text.size();) {
    const auto begin = i;
    if (text[i] == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
      continue;
    }
    if (std::isspace(static_cast<unsigned char>(text[i]))) {
      ++i;
      continue;
    }
    if (text[i] == '"') {
      i = text.find('"', i + 1) + 1;
    } else if (in_name(i)) {
      while (in_name(i)) ++i;
    } else {
      ++i;
    }
    result.emplace_back(begin, i);
  }
  return result;
}

std::string touch_skill() {
  // All files in one, so that words of all are changed.
  auto text = test::source_file("skills_pal/touch/touch.pal");
  const std::string uses = "USES \"touch_modules.pal\"\n";
  text.erase(text.find(uses), uses.size());
  return text + test::touch_modules_text();
}

std::size_t syntax_errors(const test::Checked& checked) {
  std::size_t count = 0;
  for (const auto& finding : checked.diagnostics.all()) count += finding.code == Code::PAL0101 ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("a missing word gives few syntax errors") {
  const auto text = touch_skill();
  REQUIRE(test::check_text(text).diagnostics.errors() == 0);
  std::size_t silent = 0;
  std::size_t worst = 0;
  std::size_t total = 0;
  std::string worst_text;
  const auto all = words(text);
  for (const auto& [begin, end] : all) {
    auto mutant = text;
    mutant.erase(begin, end - begin);
    const auto checked = test::check_text(mutant);
    const auto errors = syntax_errors(checked);
    total += errors;
    if (checked.diagnostics.errors() == 0) ++silent;
    if (errors > worst) {
      worst = errors;
      worst_text =
          mutant.substr(begin > 60 ? begin - 60 : 0, 120) + " without " + text.substr(begin, end - begin);
    }
  }
  CAPTURE(worst_text, silent, all.size(), total);
  CHECK(worst <= 4);
  // One each, or little more: what follows a mistake is read as if it were not there.
  CHECK(10 * total <= 11 * all.size());
}

TEST_CASE("texts that are cut off, doubled or shuffled are read safely") {
  const auto text = touch_skill();
  const auto all = words(text);
  constexpr unsigned seed = 20240607;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 300; ++round) {
    auto mutant = text;
    const auto at = [&] { return all[random() % all.size()]; };
    switch (round % 4) {
      case 0:
        mutant.resize(random() % text.size());
        break;
      case 1: {
        const auto [begin, end] = at();
        mutant.insert(begin, text.substr(begin, end - begin) + " ");
        break;
      }
      case 2: {
        const auto [begin, end] = at();
        const auto [other_begin, other_end] = at();
        mutant.replace(begin, end - begin, text.substr(other_begin, other_end - other_begin));
        break;
      }
      default:
        for (int i = 0; i < 20; ++i) mutant[random() % mutant.size()] = static_cast<char>(random() % 128);
    }
    const auto checked = test::check_text(mutant);
    CHECK(checked.diagnostics.errors() <= 210);
  }
}
