// One word too few or too many in a right text: how many errors that makes, and where.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "pal/support/render.hpp"
#include "tests/unit/frontend/specification.hpp"

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
std::vector<Word> words(const std::string& text) {
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
          {"skills_pal", "workcell.pal", "workcell.pal"},
          {"tests/package/outside/blink", "blink.pal", "blink.pal"},
          {"tests/golden/check", "wait_forms.pal", "wait_forms.pal"},
          {"tests/golden/check", "environment.pal", "environment.pal"}};
}

MemoryFileSystem files_of(const Subject& subject) {
  MemoryFileSystem files;
  for (const auto& entry : fs::directory_iterator(PAL_SOURCE_DIR "/" + subject.folder)) {
    if (entry.path().extension() == ".pal")
      files.add(entry.path().filename(), test::source_file(subject.folder + "/" + entry.path().filename().string()));
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

void check_mutant(const Subject& subject, const std::string& mutant, const std::string& change, Distribution& into) {
  auto files = files_of(subject);
  files.add(subject.file, mutant);
  const auto checked = test::check_files(files, {subject.first});
  std::ostringstream report;
  report << subject.file << ": " << change << "\n";
  render_text(checked.diagnostics.sorted(), checked.sources, report);
  std::size_t errors = 0;
  for (const auto& finding : checked.diagnostics.sorted()) errors += finding.severity == Severity::error ? 1 : 0;
  if (std::getenv("PAL_SHOW_MUTANTS") && errors > 1) std::cout << "==== " << errors << "\n" << report.str();
  into.add(errors, report.str());
}

bool is_sign(const std::string& word) {
  return word.size() == 1 && !in_name(word.front());
}

}  // namespace

TEST_CASE("distribution", "[.distribution]") {
  Distribution ends, signs, keywords, names, quotes, strays;
  for (const Subject& subject : subjects()) {
    const auto text = test::source_file(subject.folder + "/" + subject.file);
    const auto all = words(text);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Word& word = all[i];
      auto without = text;
      const bool two = word.text == "END" && i + 1 < all.size() &&
                       text.find('\n', word.begin) > all[i + 1].begin &&
                       (all[i + 1].text == "CASE" || all[i + 1].text == "WTM" || all[i + 1].text == "CONCURRENT" ||
                        all[i + 1].text == "SKILL" || all[i + 1].text == "ENVIRONMENT");
      const auto end = two ? all[i + 1].end : word.end;
      without.erase(word.begin, end - word.begin);
      const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(word.begin), '\n') + 1;
      const auto change = "line " + std::to_string(line) + " without " + text.substr(word.begin, end - word.begin);
      static const std::vector<std::string> keyword{
          "WTM", "TXM", "SPC", "RPC", "CASE", "REPEAT", "UNTIL", "CONCURRENT", "BEGIN", "EXECUTE", "DO", "ELSE",
          "TRUE", "FALSE", "AND", "OR", "NOT", "NONE", "FROM", "TO", "REQUEST", "SKILL", "MESSAGE", "CONDITION", "DEVICE", "ENVIRONMENT", "SENSOR", "LOGICAL", "MACHINE", "MODULE", "CONTROLLER", "DRIVER", "WITHIN", "FIRST", "ACTIVITY", "READS", "WRITES", "METHOD", "COMPLETION", "PARAMETER", "REQUIREMENT", "DEFAULT", "RANGE","PLACE","ON","PRIORITY","TIME","OF","COST","LATENCY","PROCESSOR","EVENT","EVERY","AT","MOST","PROTOCOL","FOREVER"};
      if (word.text == "END" || word.text == "UNTIL") {
        check_mutant(subject, without, change, ends);
      } else if (is_sign(word.text)) {
        check_mutant(subject, without, change, signs);
      } else if (std::find(keyword.begin(), keyword.end(), word.text) != keyword.end()) {
        check_mutant(subject, without, change, keywords);
      } else if (word.text.front() == '"') {
        auto open = text;
        open.erase(word.end - 1, 1);
        check_mutant(subject, open, change + " (quote)", quotes);
      } else {
        check_mutant(subject, without, change, names);
      }
      auto more = text;
      more.insert(word.begin, " stray ");
      check_mutant(subject, more, "line " + std::to_string(line) + " with stray before " + word.text, strays);
    }
  }
  std::cout << "ends " << ends << "\nsigns " << signs << "\nkeywords " << keywords << "\nnames " << names << "\nquotes "
            << quotes << "\nstrays " << strays << "\n";
  std::cout << signs.worst << keywords.worst << ends.worst << strays.worst;
}
