// Runs one golden test, or looks for codes that have none. tests/golden/CMakeLists.txt says how.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/line_difference.hpp"
#include "pal/support/render.hpp"
#include "pal/syntax/print.hpp"
#include "programs/pal/options/command_line.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"
#include "programs/pal/session/unchecked.hpp"

namespace {

struct Outcome {
  std::string text;
  bool errors = false;
};

/// Options of `pal check` that a golden asks for in its first line: "# --max-states 10", of the exact
/// analysis alone, or "# --analysis compositional".
pal::program::ProofLimits limits_in(std::string_view text) {
  pal::program::ProofLimits limits;
  if (text.starts_with("# --analysis compositional"))
    limits.analysis = pal::analyzer::AnalysisChoice::compositional;
  constexpr std::string_view option = "# --max-states ";
  if (!text.starts_with(option)) return limits;
  limits.max_states = std::stoul(std::string(text.substr(option.size(), 10)));
  limits.analysis = pal::analyzer::AnalysisChoice::exact;
  return limits;
}

/// Likewise "# --measured measured/slow.pal".
std::vector<std::string> measured_in(std::string_view text) {
  constexpr std::string_view option = "# --measured ";
  if (!text.starts_with(option)) return {};
  return {std::string(text.substr(option.size(), text.find('\n') - option.size()))};
}

/// Everything that `pal check` does.
Outcome check(const std::string& file) {
  const pal::DiskFileSystem files;
  std::ostringstream out;
  const pal::program::Console console{out, out, files};
  pal::program::Session session;
  std::ifstream in(file, std::ios::binary);
  std::string first;
  std::getline(in, first);
  pal::program::Selection selection;
  selection.files = {file};
  selection.measured = measured_in(first);
  pal::program::read(selection, console, session);
  if (!session.diagnostics.has_errors()) {
    const auto limits = limits_in(session.sources.text(pal::FileId(0)));
    const auto proofs = pal::program::prove(session, limits);
    pal::program::report_unmet(proofs, false, session);
    if (first.starts_with("# --require-verdicts"))
      pal::program::report_unchecked(
          pal::program::unchecked(session, proofs, pal::program::Unproved::nowhere), session);
  }
  pal::render_text(session.diagnostics.sorted(), session.sources, out);
  return {out.str(), session.diagnostics.has_errors()};
}

/// Everything that `pal operation check` says, with the skills and the cell beside it; with a log beside it
/// its storyboard, too.
Outcome check_operation(const std::string& file) {
  const pal::DiskFileSystem files;
  std::ostringstream out;
  auto status = pal::program::run({"operation", "check", file, "--skills", "skills.pal", "-e", "cell.pal",
                                   "--location", "HOME", "--sensor", "eye", "--figure", "light"},
                                  {out, out, files});
  const std::string log = std::filesystem::path(file).replace_extension(".jsonl").string();
  if (std::filesystem::exists(log))
    status = pal::program::run({"operation", "storyboard", file, "--skills", "skills.pal", "--run", log},
                               {out, out, files});
  return {out.str(), status == pal::program::ExitStatus::wrong_specification};
}

Outcome run(const std::string& stage, const std::string& file) {
  if (stage == "check") return check(file);
  if (stage == "operation") return check_operation(file);
  const pal::DiskFileSystem files;
  pal::SourceManager sources;
  pal::Diagnostics diagnostics;
  std::ostringstream out;
  const auto trees = pal::check::read_sources(files, sources, {file}, diagnostics);
  if (stage == "tree") {
    for (const auto& tree : trees) pal::syntax::dump(tree, sources, out);
  } else if (stage == "format") {
    if (!trees.empty() && trees.front().complete) pal::syntax::print(trees.front(), out);
  } else {
    const auto specification = pal::check::check(trees, diagnostics);
    if (stage == "pan") {
      for (const auto& network : specification.skills) pal::pan::dump(network, out);
      for (const auto& network : specification.sketches) pal::pan::dump(network, out);
      for (const auto& environment : specification.environments) pal::pan::dump(environment, out);
    }
  }
  // What a stage says of a text that is right belongs to the tests of `check`.
  if (diagnostics.has_errors()) pal::render_text(diagnostics.sorted(), sources, out);
  return {out.str(), diagnostics.has_errors()};
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

int compare(const std::string& stage, const std::string& file) {
  const auto outcome = run(stage, file);
  const bool named_fail = file.starts_with("fail_");
  if (named_fail != outcome.errors) {
    std::cout << file
              << (outcome.errors ? " has errors, so its name must begin with fail_\n"
                                 : " has no errors, so its name must not begin with fail_\n")
              << outcome.text;
    return 1;
  }
  const auto expectation = std::filesystem::path(file).replace_extension(".expected");
  if (const char* rewrite = std::getenv("PAL_GOLDEN_REWRITE"); rewrite != nullptr && *rewrite == '1') {
    std::ofstream(expectation, std::ios::binary) << outcome.text;
    return 0;
  }
  const auto expected = read(expectation);
  if (std::filesystem::exists(expectation) && expected == outcome.text) return 0;
  std::cout << pal::line_difference("expected", expected, "found", outcome.text);
  return 1;
}

int look_for_codes() {
  std::string all;
  for (const char* folder : {".", "../operation"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".expected") all += read(entry.path());
  }
  int missing = 0;
  for (std::size_t i = 0; i < pal::code_count(); ++i) {
    const auto code = static_cast<pal::Code>(i);
    const auto shown = "[" + std::string(pal::name(code)) + "]";
    if (all.find(shown) == std::string::npos) {
      std::cout << pal::name(code) << " (" << pal::title(code) << ") has no golden test\n";
      ++missing;
    }
  }
  return missing == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 1 && arguments[0] == "codes") return look_for_codes();
  if (arguments.size() == 2) return compare(arguments[0], arguments[1]);
  std::cerr << "usage: golden_runner STAGE FILE | golden_runner codes\n";
  return 2;
}
