// One word too few or too many in a right text: how many errors that makes, and where.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "pal/support/render.hpp"
#include "tests/support/touch_files.hpp"
#include "tests/unit/check/specification.hpp"

using namespace pal;
namespace fs = std::filesystem;

namespace {

struct Word {
  std::size_t begin, end;
  std::string text;  // in capitals
};

bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
}

/// The words, signs and texts, comments left out: enough of PAL's lexer to take words away.
std::vector<Word> words_of(const std::string& text) {
  std::vector<Word> result;
  for (std::size_t i = 0; i < text.size();) {
    const auto begin = i;
    if (text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (std::isspace(static_cast<unsigned char>(text[i]))) {
      ++i;
      continue;
    }
    if (text[i] == '"') {
      i = text.find('"', i + 1) + 1;
    } else if (in_name(text[i])) {
      const bool number = std::isdigit(static_cast<unsigned char>(text[i]));
      while (i < text.size() && (in_name(text[i]) || (number && text[i] == '.'))) ++i;
    } else {
      ++i;
    }
    std::string word = text.substr(begin, i - begin);
    for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    result.push_back({begin, i, std::move(word)});
  }
  return result;
}

/// A right specification: `file` is changed, `first` is checked.
struct Subject {
  std::string folder, first, file;
};

std::vector<Subject> subjects() {
  return {{"skills_pal/touch", "touch.pal", "touch.pal"},
          {"skills_pal/touch", "touch.pal", "touch_modules.pal"},
          {"skills_pal/touch", "touch.pal", "../modules/alter.pal"},
          {"skills_pal", "workcell.pal", "workcell.pal"},
          {"tests/package/outside/blink", "blink.pal", "blink.pal"},
          {"tests/golden/check", "wait_forms.pal", "wait_forms.pal"},
          {"tests/golden/check", "environment.pal", "environment.pal"}};
}

MemoryFileSystem files_of(const Subject& subject) {
  MemoryFileSystem files;
  for (const auto& entry : fs::directory_iterator(PAL_SOURCE_DIR "/" + subject.folder)) {
    if (entry.path().extension() == ".pal")
      files.add(entry.path().filename(),
                test::source_file(subject.folder + "/" + entry.path().filename().string()));
  }
  for (const auto& path : test::touch_modules) {
    if (path.starts_with("skills_pal/modules/"))
      files.add("../modules/" + fs::path(path).filename().string(), test::source_file(path));
  }
  if (subject.folder == "tests/golden/check") {
    files.add("parts/base.pal", test::source_file("tests/golden/check/parts/base.pal"));
  }
  return files;
}

/// How many mutants gave how many errors.
struct Distribution {
  std::map<std::size_t, std::size_t> count;
  std::string worst;
  std::size_t most = 0;

  void add(std::size_t errors, const std::string& report) {
    ++count[errors];
    if (errors <= most) return;
    most = errors;
    worst = report;
  }
};

std::ostream& operator<<(std::ostream& out, const Distribution& distribution) {
  for (const auto& [errors, mutants] : distribution.count) out << "  " << errors << ": " << mutants;
  return out;
}

void expect_mutant(const Subject& subject, const std::string& mutant, const std::string& change,
                   Distribution& into) {
  auto files = files_of(subject);
  files.add(subject.file, mutant);
  const auto checked = test::check_files(files, {subject.first});
  std::ostringstream report;
  report << subject.file << ": " << change << "\n";
  render_text(checked.diagnostics.sorted(), checked.sources, report);
  std::size_t errors = 0;
  for (const auto& finding : checked.diagnostics.sorted())
    errors += finding.severity == Severity::error ? 1 : 0;
  if (std::getenv("PAL_SHOW_MUTANTS") != nullptr && errors > 1)
    std::cout << "==== " << errors << "\n" << report.str();
  into.add(errors, report.str());
}

bool is_sign(const std::string& word) {
  return word.size() == 1 && !in_name(word.front());
}

/// PAL's keywords, as the grammar has them.
bool is_keyword(const std::string& word) {
  static const std::string grammar = test::source_file("grammar/PalLexer.g4");
  return word.size() > 1 && grammar.find("\n" + word + " ") != std::string::npos;
}

/// The word after END on its line belongs to it.
bool is_end_of_two(const std::vector<Word>& all, std::size_t i, const std::string& text) {
  return all[i].text == "END" && i + 1 < all.size() && text.find('\n', all[i].begin) > all[i + 1].begin;
}

struct Distributions {
  Distribution ends, signs, keywords, quotes, strays;
};

void mutate(const Subject& subject, Distributions& into) {
  const auto text = test::source_file(subject.folder + "/" + subject.file);
  const auto all = words_of(text);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Word& word = all[i];
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(word.begin), '\n') + 1;
    const auto place = "line " + std::to_string(line);
    const bool two = is_end_of_two(all, i, text);
    const auto end = two ? all[i + 1].end : word.end;
    const auto gone = text.substr(word.begin, end - word.begin);
    auto without = text;
    without.erase(word.begin, end - word.begin);
    if (word.text == "END" || word.text == "UNTIL") {
      expect_mutant(subject, without, place + " without " + gone, into.ends);
    } else if (is_sign(word.text)) {
      expect_mutant(subject, without, place + " without " + gone, into.signs);
    } else if (is_keyword(word.text)) {
      expect_mutant(subject, without, place + " without " + gone, into.keywords);
    } else if (word.text.front() == '"') {
      auto open = text;
      open.erase(word.end - 1, 1);
      expect_mutant(subject, open, place + " without the quote after " + gone, into.quotes);
    }
    if (i % 2 == 1) continue;  // every other place will do
    auto more = text;
    more.insert(word.begin, " stray ");
    expect_mutant(subject, more, place + " with stray before " + gone, into.strays);
  }
}

}  // namespace

TEST_CASE("a missing or superfluous word gives one error, rarely two") {
  Distributions all;
  for (const Subject& subject : subjects()) mutate(subject, all);
  std::ostringstream told;
  told << "errors: mutants\nends" << all.ends << "\nsigns" << all.signs << "\nkeywords" << all.keywords
       << "\nquotes" << all.quotes << "\nstrays" << all.strays << "\n";
  if (std::getenv("PAL_SHOW_MUTANTS") != nullptr) std::cout << told.str();
  INFO(told.str());
  const auto check = [](const Distribution& distribution, std::size_t most, std::size_t percent_with_one) {
    INFO(distribution.worst);
    CHECK(distribution.most <= most);
    std::size_t sum = 0;
    std::size_t few = 0;
    for (const auto& [errors, mutants] : distribution.count) {
      sum += mutants;
      if (errors <= 1) few += mutants;
    }
    CHECK(100 * few >= percent_with_one * sum);
  };
  check(all.ends, 1, 100);
  check(all.signs, 1, 100);
  check(all.keywords, 6, 90);  // a wait without its WITHIN leaves its arms, its ELSE and its END behind
  check(all.quotes, 1, 100);
  check(all.strays, 2, 90);
  CHECK(all.ends.count.count(0) == 0);  // none goes unnoticed
}
