// Plans and generated files, whole. To take new ones over after looking at them: PAL_GOLDEN_REWRITE=1.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "codegen/explain.hpp"
#include "codegen/generate.hpp"
#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/render.hpp"

using namespace pal;

namespace {

const std::string folder = PAL_SOURCE_DIR "/tests/golden/codegen/";

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Files by names that are the same wherever the source tree is.
class InSourceTree final : public FileSystem {
 public:
  explicit InSourceTree(std::string working_folder) : folder_(std::move(working_folder)) {}
  std::variant<std::string, FileError> read(const std::string& path,
                                            std::size_t most = largest_file) const override {
    return disk_.read(path.starts_with('/') ? path : PAL_SOURCE_DIR "/" + folder_ + path, most);
  }

 private:
  std::string folder_;
  DiskFileSystem disk_;
};

struct Input {
  Input(const std::string& skill, const std::string& environment, const std::string& working_folder = "") {
    specification = check::check(
        check::read_sources(InSourceTree(working_folder), sources, {skill, environment}, diagnostics),
        diagnostics);
    std::ostringstream findings;
    render_text(diagnostics.sorted(), sources, findings);
    INFO(findings.str());
    REQUIRE_FALSE(diagnostics.has_errors());
    REQUIRE(specification.skills.size() == 1);
    REQUIRE(specification.environments.size() == 1);
  }
  std::optional<codegen::Plan> plan() {
    return codegen::make_plan(specification.skills.front(), specification.environments.front(), sources,
                              diagnostics);
  }
  SourceManager sources;
  Diagnostics diagnostics;
  check::Specification specification;
};

void expect_golden(const std::string& file, const std::string& found) {
  if (const char* rewrite = std::getenv("PAL_GOLDEN_REWRITE"); rewrite != nullptr && *rewrite == '1') {
    std::ofstream(folder + file, std::ios::binary) << found;
    return;
  }
  CHECK(found == read(folder + file));
}

std::string all(const std::vector<codegen::GeneratedFile>& files) {
  std::string text;
  for (const auto& file : files) text += "==== " + file.name + "\n" + file.text;
  return text;
}

}  // namespace

TEST_CASE("plan and code of a skill with every statement and odd names") {
  Input input("tests/golden/codegen/odd_names.pal", "tests/golden/codegen/bench.pal");
  const auto plan = input.plan();
  REQUIRE(plan);
  std::ostringstream text;
  codegen::dump(*plan, text);
  expect_golden("odd_names.plan", text.str());
  expect_golden("odd_names.expected", all(codegen::emit(*plan)));
}

TEST_CASE("plan and code of a module that several blocks execute") {
  Input input("tests/golden/codegen/at_a_time.pal", "tests/golden/codegen/at_a_time_bench.pal");
  const auto plan = input.plan();
  REQUIRE(plan);
  std::ostringstream text;
  codegen::dump(*plan, text);
  expect_golden("at_a_time.plan", text.str());
  expect_golden("at_a_time.expected", all(codegen::emit(*plan)));
}

TEST_CASE("plan and code of a skill with arrays and texts") {
  Input input("tests/golden/codegen/survey.pal", "tests/golden/codegen/survey_bench.pal");
  const auto plan = input.plan();
  REQUIRE(plan);
  std::ostringstream text;
  codegen::dump(*plan, text);
  expect_golden("survey.plan", text.str());
  expect_golden("survey.expected", all(codegen::emit(*plan)));
}

TEST_CASE("plan and code of approach to touch") {
  Input input("skills_pal/touch/touch.pal", "skills_pal/workcell.pal");
  const auto plan = input.plan();
  REQUIRE(plan);
  std::ostringstream text;
  codegen::dump(*plan, text);
  expect_golden("touch.plan", text.str());
  expect_golden("touch.expected", all(codegen::emit(*plan)));
}

TEST_CASE("debug lines: each line of a body names its line of PAL, and the code is the same") {
  Input input("tests/golden/codegen/odd_names.pal", "tests/golden/codegen/bench.pal");
  const auto plan = input.plan();
  REQUIRE(plan);
  const auto plain = codegen::emit(*plan);
  const auto files = codegen::emit(*plan, {.debug_lines = true});
  REQUIRE(files.size() == plain.size());
  for (std::size_t f = 0; f < files.size(); ++f) {
    INFO(files[f].name);
    if (files[f].name != "namespace_modules.cpp") {
      CHECK(files[f].text == plain[f].text);
      continue;
    }
    expect_golden("odd_names_lines.expected", files[f].text);
    // Without them it is the plain file; where it stands for itself, the next line has the number that is
    // said.
    std::istringstream lines(files[f].text);
    std::string rest;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.starts_with("#line ") && line.ends_with("\"namespace_modules.cpp\""))
        CHECK(line == "#line " + std::to_string(number + 1) + " \"namespace_modules.cpp\"");
      if (!line.starts_with("#line ")) rest += line + "\n";
    }
    const std::size_t pragma = rest.find("\n// To GCC, ");
    REQUIRE(pragma != std::string::npos);
    rest.erase(pragma, rest.find("#endif\n") + 7 - pragma);
    CHECK(rest == plain[f].text);
  }
}

TEST_CASE("what a skill will be at run time") {
  const auto explained = [](Input input) {
    const auto plan = input.plan();
    REQUIRE(plan);
    std::ostringstream text;
    codegen::explain(*plan, text);
    return text.str();
  };
  expect_golden("touch.explained", explained({"skills_pal/touch/touch.pal", "skills_pal/workcell.pal"}));
  expect_golden("at_a_time.explained", explained({"tests/golden/codegen/at_a_time.pal",
                                                  "tests/golden/codegen/at_a_time_bench.pal"}));
  expect_golden("range_finder.explained",
                explained({"examples/range_finder/range_finder.pal", "examples/range_finder/cell.pal"}));
}

TEST_CASE("the same text from whatever folder") {
  const std::string top = PAL_SOURCE_DIR "/skills_pal/";
  const std::string expected = read(folder + "touch.expected");
  const auto generated = [](Input input) {
    const auto plan = input.plan();
    REQUIRE(plan);
    return all(codegen::emit(*plan));
  };
  CHECK(generated({"touch.pal", "../workcell.pal", "skills_pal/touch/"}) == expected);
  CHECK(generated({"../touch/touch.pal", "../workcell.pal", "skills_pal/rub/"}) == expected);
  CHECK(generated({top + "touch/touch.pal", top + "workcell.pal"}) == expected);
}

TEST_CASE("an environment that lacks something gives findings and no code") {
  Input input("skills_pal/touch/touch.pal", "skills_pal/workcell.pal");
  auto& environment = input.specification.environments.front();
  std::string code;
  std::string message;
  SECTION("a thread without a place") {
    std::erase_if(environment.placements, [](const auto& place) { return place.thread == "LS1"; });
    code = "PAL0721";
    message = "environment workcell does not place LS1";
  }
  SECTION("a place on no processor") {
    std::erase_if(environment.processors, [](const auto& processor) { return processor.name == "P2"; });
    code = "PAL0713";
    message = "environment workcell has no processor P2";
  }
  SECTION("an activity without a time") {
    std::erase_if(environment.activities, [](const auto& time) { return time.activity == "hold"; });
    code = "PAL0725";
    message = "environment workcell gives activity hold of MC1 no time";
  }
  CHECK(codegen::generate(input.specification.skills.front(), environment, input.sources, input.diagnostics)
            .empty());
  REQUIRE(input.diagnostics.errors() == 1);
  const auto sorted = input.diagnostics.sorted();
  const auto& found = *std::find_if(sorted.begin(), sorted.end(),
                                    [](const auto& each) { return each.severity == Severity::error; });
  CHECK(name(found.code) == code);
  CHECK(found.message == message);
}
