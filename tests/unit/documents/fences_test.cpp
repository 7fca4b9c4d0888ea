// Every piece of PAL in the documents is compiled.
//
// The first line of a fence says what it is:
//   ```pal                    a whole file, without errors
//   ```pal file=NAME          a whole file, which later fences of the document can name in USES
//   ```pal statements         statements of a module, slots of a SKILL, items of an ENVIRONMENT, headings of
//   a module: wrapped
//   ```pal slots              in what they belong to, they have no syntax errors
//   ```pal items
//   ```pal headings
//   … error=PAL0123           gives this error (and maybe others)
//   … untidy                  is not in canonical layout, and so shows what else may be written
// The files in skills_pal, and in skills_pal/touch, can be named in USES too, by their names; modules as
// ../modules/NAME.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "pal/support/diagnostic_code.hpp"
#include "pal/syntax/format.hpp"
#include "tests/unit/check/specification.hpp"

using namespace pal;

namespace {

namespace fs = std::filesystem;

struct Fence {
  int line = 0;
  std::vector<std::string> words;  // after ```
  std::string text;

  std::string after(const std::string& key) const {
    for (const auto& word : words) {
      if (word.starts_with(key)) return word.substr(key.size());
    }
    return {};
  }
  bool is(const std::string& kind) const { return std::count(words.begin(), words.end(), kind) != 0; }
};

std::vector<Fence> fences_of(const std::string& document) {
  std::vector<Fence> fences;
  std::istringstream lines(document);
  Fence* open = nullptr;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with("```") && open == nullptr) {
      Fence fence{number, {}, {}};
      std::istringstream words(line.substr(3));
      for (std::string word; words >> word;) fence.words.push_back(word);
      fences.push_back(fence);
      open = &fences.back();
    } else if (line.starts_with("```")) {
      open = nullptr;
    } else if (open != nullptr) {
      open->text += line + "\n";
    }
  }
  std::erase_if(fences,
                [](const Fence& fence) { return fence.words.empty() || fence.words.front() != "pal"; });
  return fences;
}

/// What a fragment stands in.
std::string wrapped(const Fence& fence) {
  if (fence.is("statements")) return "Skill Module: Example\nBEGIN\n" + fence.text + "END\n";
  if (fence.is("slots")) return "SKILL example\n" + fence.text + "END SKILL\n";
  if (fence.is("items")) return "ENVIRONMENT example\n" + fence.text + "END ENVIRONMENT\n";
  if (fence.is("headings")) return "Logical Sensor: Example\n" + fence.text;
  return fence.text;
}

void add_folder(const std::string& folder, MemoryFileSystem& files, const std::string& under = "") {
  for (const auto& entry : fs::directory_iterator(fs::path(PAL_SOURCE_DIR) / folder)) {
    if (entry.path().extension() != ".pal") continue;
    const auto name = entry.path().filename().string();
    files.add(under + name, test::source_file(folder + "/" + name));
  }
}

void expect_fence(const Fence& fence, MemoryFileSystem& files) {
  CAPTURE(fence.line);
  const auto text = wrapped(fence);
  CAPTURE(text);
  const auto named = fence.after("file=");
  const auto name = named.empty() ? "example.pal" : named;
  files.add(name, text);
  const auto checked = test::check_files(files, {name});
  std::string found;
  for (const auto& finding : checked.diagnostics.all()) {
    if (finding.severity == Severity::error)
      found += std::string(pal::name(finding.code)) + " " + finding.message + "\n";
  }
  CAPTURE(found);
  if (const auto code = fence.after("error="); !code.empty()) {
    CHECK(found.find(code) != std::string::npos);
  } else if (text == fence.text) {
    CHECK(found.empty());
  } else {
    CHECK(checked.trees.at(0).complete);
  }
}

std::vector<std::string> documents() {
  std::vector<std::string> paths{"README.md"};
  const fs::path root(PAL_SOURCE_DIR);
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    const auto name = fs::relative(entry.path(), root).generic_string();
    // The findings' examples are checked where they come from.
    if (entry.path().extension() == ".md" && name != "docs/reference/diagnostics.md") paths.push_back(name);
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

TEST_CASE("every piece of PAL in the documents is what it says") {
  for (const auto& path : documents()) {
    CAPTURE(path);
    MemoryFileSystem files;
    add_folder("skills_pal", files);
    add_folder("skills_pal/touch", files);
    add_folder("skills_pal/modules", files, "../modules/");
    for (const auto& fence : fences_of(test::source_file(path))) expect_fence(fence, files);
  }
}

TEST_CASE("the reference has examples, and they are in canonical layout") {
  const auto fences = fences_of(test::source_file("docs/reference/language.md"));
  CHECK(fences.size() > 20);
  for (const auto& fence : fences) {
    if (!fence.after("error=").empty() || fence.is("untidy")) continue;
    CAPTURE(fence.line);
    SourceManager sources;
    Diagnostics diagnostics;
    const auto text = wrapped(fence);
    const auto formatted = syntax::format(sources, sources.add("a.pal", text), diagnostics);
    REQUIRE(formatted);
    // Fragments stand at the left of the page.
    std::istringstream left(*formatted);
    std::istringstream right(text);
    std::string a;
    std::string b;
    while (std::getline(left, a) && std::getline(right, b)) {
      const auto words = [](const std::string& line) {
        return line.substr(std::min(line.find_first_not_of(' '), line.size()));
      };
      CHECK(words(a) == words(b));
    }
  }
}

TEST_CASE("the reference names every keyword") {
  const auto reference = test::source_file("docs/reference/language.md");
  const auto lexer = test::source_file("grammar/PalLexer.g4");
  const std::regex keyword("\n([A-Z]+) *: [A-Z](?: [A-Z])* ;");
  int keywords = 0;
  for (std::sregex_iterator at(lexer.begin(), lexer.end(), keyword), end; at != end; ++at) {
    const std::string word = (*at)[1];
    CAPTURE(word);
    ++keywords;
    CHECK(std::regex_search(reference, std::regex("\\b" + word + "\\b")));
  }
  CHECK(keywords > 80);
}
