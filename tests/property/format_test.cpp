// The canonical layout keeps every word, every comment and the meaning. It is a fixed point.
#include <catch2/catch.hpp>
#include <cctype>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "pal/pan/dump.hpp"
#include "pal/support/edit.hpp"
#include "pal/syntax/format.hpp"
#include "tests/support/random_program.hpp"
#include "tests/unit/check/specification.hpp"

using namespace pal;

namespace {

std::optional<std::string> format(const std::string& text) {
  SourceManager sources;
  Diagnostics diagnostics;
  return syntax::format(sources, sources.add("a.pal", text), diagnostics);
}

/// Laid out by edits, also around errors: of all lines, or of some.
std::string laid_out(const std::string& text, std::size_t first = 0, std::size_t end = std::string::npos) {
  SourceManager sources;
  const FileId file = sources.add("a.pal", text);
  const auto to = static_cast<std::uint32_t>(std::min(end, text.size()));
  return apply(syntax::layout_edits(sources, file, {file, static_cast<std::uint32_t>(first), to}), file,
               text);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The words and the comments of a text, found without the compiler's own lexer.
struct Parts {
  std::vector<std::string> words;
  std::vector<std::string> comments;
};

Parts parts_of(const std::string& text) {
  Parts parts;
  const auto is_part_of_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  };
  for (std::size_t i = 0; i < text.size();) {
    auto end = i + 1;
    if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      i = end;
      continue;
    }
    if (text[i] == '#') {
      end = std::min(text.find_first_of("\r\n", i), text.size());
      parts.comments.push_back(text.substr(i, end - i));
    } else {
      if (text[i] == '"') {
        while (text[end] != '"') end += text[end] == '\\' ? 2 : 1;
        ++end;
      } else if (is_part_of_word(text[i])) {
        while (end < text.size() && is_part_of_word(text[end])) ++end;
      }
      parts.words.push_back(text.substr(i, end - i));
    }
    i = end;
  }
  return parts;
}

std::string in_small_letters(std::string text) {
  for (auto& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The same words with other spaces between them, and with comments that are told apart by their numbers.
class Untidy {
 public:
  Untidy(std::uint64_t seed, unsigned comments_in_ten) : engine_(seed), comments_in_ten_(comments_in_ten) {}

  std::string operator()(const std::string& text) {
    std::string result = gap();
    for (const auto& word : parts_of(text).words) result += word + gap();
    return result;
  }

  int comments() const { return comments_; }

 private:
  unsigned below(unsigned n) { return static_cast<unsigned>(engine_() % n); }

  std::string spaces() {
    static const char* const kinds[] = {" ", " ", "  ", "\t", "\n", "\n\n", "\r\n", " \n \n\n\t", "      "};
    std::string result = kinds[below(std::size(kinds))];
    return result;
  }

  std::string gap() {
    std::string result = spaces();
    while (below(10) < comments_in_ten_) {
      result += "# " + std::to_string(comments_++) + (below(2) == 0 ? "  " : " \" 'WTM( ") + "\n" + spaces();
    }
    return result;
  }

  std::mt19937_64 engine_;
  unsigned comments_in_ten_;
  int comments_ = 0;
};

std::string meaning(const std::string& text) {
  const auto checked = test::check_text(text);
  std::ostringstream out;
  for (const auto& network : checked.specification.skills) pan::dump(network, out);
  for (const auto& network : checked.specification.sketches) pan::dump(network, out);
  for (const auto& environment : checked.specification.environments) pan::dump(environment, out);
  for (const auto& finding : checked.diagnostics.sorted()) out << finding.message << '\n';
  return out.str();
}

void expect_format(const std::string& text, bool with_meaning) {
  CAPTURE(text);
  const auto once = format(text);
  REQUIRE(once);
  CAPTURE(*once);
  const auto before = parts_of(text);
  const auto after = parts_of(*once);
  REQUIRE(after.words.size() == before.words.size());
  for (std::size_t i = 0; i < before.words.size(); ++i) {
    REQUIRE(in_small_letters(after.words[i]) == in_small_letters(before.words[i]));
  }
  REQUIRE(after.comments.size() == before.comments.size());
  for (std::size_t i = 0; i < before.comments.size(); ++i) {
    REQUIRE(before.comments[i].find(after.comments[i]) == 0);
    const auto rest = before.comments[i].substr(after.comments[i].size());
    REQUIRE(rest.find_first_not_of(' ') == std::string::npos);
  }
  REQUIRE(format(*once) == once);
  REQUIRE(once->find(" \n") == std::string::npos);
  REQUIRE(once->find("\n\n\n") == std::string::npos);
  REQUIRE(once->find('\r') == std::string::npos);
  if (with_meaning) REQUIRE(meaning(*once) == meaning(text));
}

}  // namespace

TEST_CASE(
    "every comment of a random program survives its formatting, once and in order, and so does its meaning") {
  constexpr std::uint64_t first_seed = 20261121;
  int comments = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + 300; ++seed) {
    CAPTURE(seed);
    const auto body = test::RandomProgram(seed).module();
    Untidy untidy(seed, static_cast<unsigned>(seed % 10));  // up to nine gaps in ten
    expect_format(test::program_declarations + untidy(body), seed % 4 == 0);
    comments += untidy.comments();
  }
  CHECK(comments > 10000);
}

TEST_CASE("every comment in every kind of unit survives") {
  for (const auto* path : {"skills_pal/workcell.pal", "skills_pal/touch/touch.pal",
                           "skills_pal/modules/z_force.pal", "skills_pal/modules/alter.pal",
                           "examples/pull_test/pull_test.pal", "tests/golden/check/environment.pal",
                           "tests/golden/check/wait_forms.pal", "tests/golden/check/words_as_names.pal",
                           "tests/golden/check/keywords_any_case.pal", "tests/golden/check/figure_3_6.pal"}) {
    CAPTURE(path);
    for (unsigned comments_in_ten = 0; comments_in_ten < 10; ++comments_in_ten) {
      expect_format(Untidy(comments_in_ten, comments_in_ten)(test::source_file(path)),
                    comments_in_ten % 5 == 0);
    }
  }
}

TEST_CASE("long lines keep every word and comment, and are broken as late as possible") {
  const std::set<std::string> names{"alter",        "answer-alter", "correction",  "extract-z", "force",
                                    "force-torque", "fresh-force",  "motion",      "pc-force",  "pc-reach",
                                    "port",         "reached",      "stand-still", "tick",      "wrench"};
  const std::string longer = "-that-is-known-by-a-very-long-name-because-some-people-prefer-such-names";
  for (const auto* path :
       {"skills_pal/workcell.pal", "skills_pal/touch/touch.pal", "skills_pal/modules/z_force.pal",
        "skills_pal/modules/alter.pal", "tests/golden/check/wait_forms.pal"}) {
    CAPTURE(path);
    std::string text;
    for (const auto& word : parts_of(test::source_file(path)).words) {
      const bool renamed = names.count(word) != 0;
      text += word + (renamed ? longer : "") + " ";
    }
    for (unsigned comments_in_ten = 0; comments_in_ten < 4; ++comments_in_ten) {
      expect_format(Untidy(comments_in_ten, comments_in_ten)(text), false);
    }
    std::istringstream lines(format(text).value_or(""));
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(line);
      const bool has_place_to_break =
          line.find(',') != std::string::npos || line.find(" AT ") != std::string::npos;
      CHECK((line.size() <= 120 || !has_place_to_break || line.find('(') != std::string::npos));
    }
  }
}

TEST_CASE("a program printed from a tree is in the canonical layout") {
  constexpr std::uint64_t first_seed = 7;
  for (std::uint64_t seed = first_seed; seed < first_seed + 200; ++seed) {
    CAPTURE(seed);
    const auto body = test::RandomProgram(seed).module();
    REQUIRE(format(body) == body);
  }
}

TEST_CASE("a text with a half-typed line is laid out around it, and loses no word") {
  std::size_t texts = 0;
  std::size_t around = 0;
  for (const auto* path : {"skills_pal/touch/touch.pal", "examples/pull_test/pull_test.pal"}) {
    CAPTURE(path);
    const auto tidy = lines_of(test::source_file(path));
    for (std::size_t typed = 0; typed < tidy.size(); ++typed) {
      if (tidy[typed].size() < 8 || tidy[typed].find('"') != std::string::npos) continue;
      std::string untidy, expected;
      for (std::size_t i = 0; i < tidy.size(); ++i) {
        const auto words = std::min(tidy[i].find_first_not_of(' '), tidy[i].size());
        const bool half = i == typed;
        const std::string line = half ? tidy[i].substr(0, tidy[i].size() - 4) : tidy[i];
        untidy += (half ? line : "   " + tidy[i].substr(words)) + "\n";
        expected += line + "\n";
      }
      CAPTURE(untidy);
      const std::string result = laid_out(untidy);
      REQUIRE(parts_of(result).words.size() == parts_of(untidy).words.size());
      REQUIRE(laid_out(result) == result);
      ++texts;
      if (result == expected) ++around;
    }
  }
  CAPTURE(texts, around);
  CHECK(3 * around > texts);
}

TEST_CASE("a range is laid out, and nothing else") {
  const std::string text = "MESSAGE   a : SIGNAL\n\nMESSAGE b :   REAL N\n\nMESSAGE c  :  SIGNAL\n";
  const std::size_t second = text.find("MESSAGE b");
  CHECK(laid_out(text, second, second) ==
        "MESSAGE   a : SIGNAL\n\nMESSAGE b : REAL N\n\nMESSAGE c  :  SIGNAL\n");
}
