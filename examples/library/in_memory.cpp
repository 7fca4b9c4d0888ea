// Checks a text in memory as an editor does. It prints findings with their ranges and edits, and makes the
// edits. It decides the requirements within a deadline. in_memory FILE MILLISECONDS
#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>

#include "analyzer/analysis.hpp"
#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/edit.hpp"
#include "pal/support/file_system.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream file(argv[1]);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto begin = std::chrono::steady_clock::now();
  pal::analyzer::Options options;
  options.clock = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  options.deadline = std::stod(argv[2]) / 1000;
  options.stop = [&options] { return options.clock() > *options.deadline; };
  options.verdicts_only = true;  // no search for the worst runs
  for (bool changed = true; changed && !options.stop();) {
    const pal::MemoryFileSystem files({{"text.pal", text}});
    pal::SourceManager sources;
    pal::Diagnostics diagnostics;
    const auto trees = pal::check::read_sources(files, sources, {"text.pal"}, diagnostics);
    const auto specification = pal::check::check(trees, diagnostics, options.stop);
    std::vector<pal::Edit> edits;
    for (const auto& finding : diagnostics.sorted()) {
      const auto from = sources.line_column(finding.where.file, finding.where.begin);
      const auto to = sources.line_column(finding.where.file, finding.where.end);
      std::cout << from.line << ':' << from.column << '-' << to.line << ':' << to.column << ' '
                << finding.message << '\n';
      for (const auto& edit : finding.fix)
        std::cout << "  '" << sources.text(edit.where) << "' becomes '" << edit.text << "'\n";
      if (edits.empty()) edits = finding.fix;
    }
    changed = !edits.empty();
    if (changed) text = pal::apply(edits, edits.front().where.file, text);
    if (changed || diagnostics.has_errors()) continue;
    for (const auto& skill : specification.skills) {
      const auto problem =
          pal::analyzer::make_problem(skill, specification.environments.at(0), diagnostics, &sources);
      if (!problem) return 1;
      const auto analysis =
          pal::analyzer::analyze(*problem, pal::analyzer::AnalysisChoice::automatic, options);
      for (const auto& verdict : analysis.verdicts)
        std::cout << verdict.requirement << ": " << pal::analyzer::name(verdict.state) << '\n';
    }
  }
}
