// Proves the requirements of a skill and prints each verdict: prove SKILL.pal ENVIRONMENT.pal. Exit status 0
// if all hold.
#include <iostream>

#include "analyzer/analysis.hpp"
#include "analyzer/problem/problem.hpp"
#include "pal/check/check.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/file_system.hpp"
#include "pal/support/render.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "prove: give a skill and an environment: prove SKILL.pal ENVIRONMENT.pal\n";
    return 2;
  }
  pal::SourceManager sources;
  pal::Diagnostics diagnostics;
  const auto trees =
      pal::check::read_sources(pal::DiskFileSystem(), sources, {argv[1], argv[2]}, diagnostics);
  const pal::check::Specification specification = pal::check::check(trees, diagnostics);

  bool all_hold = !specification.skills.empty() && !specification.environments.empty();
  if (!diagnostics.has_errors()) {
    for (const auto& skill : specification.skills) {
      for (const auto& environment : specification.environments) {
        const auto problem = pal::analyzer::make_problem(skill, environment, diagnostics, &sources);
        if (!problem) continue;  // the diagnostics say why
        const auto analysis = pal::analyzer::analyze(*problem, pal::analyzer::AnalysisChoice::automatic);
        for (const pal::analyzer::Verdict& verdict : analysis.verdicts) {
          std::cout << verdict.requirement << ": " << pal::analyzer::name(verdict.state) << "\n";
          all_hold = all_hold && verdict.state == pal::analyzer::VerdictState::holds;
        }
      }
    }
  }
  pal::render_text(diagnostics.sorted(), sources, std::cerr);
  return !diagnostics.has_errors() && all_hold ? 0 : 1;
}
