#include "programs/pal/studies/study_charts.hpp"

#include <filesystem>
#include <ostream>
#include <set>
#include <stdexcept>
#include <vector>

#include "analyzer/chart/chart.hpp"
#include "pal/support/output.hpp"
#include "programs/pal/reports/proof_chart.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/studies/engines.hpp"
#include "programs/pal/studies/progress.hpp"
#include "study/cores.hpp"

namespace pal::program {
namespace {

std::string file_of(const WorstRuns& how, const study::Table& table, const study::Row& row) {
  const study::Pair& pair = table.pairs[row.pair];
  return how.folder + "/" + std::to_string(row.point) + "." + pair.skill + "." + pair.environment + "." +
         table.requirements[row.requirement] + ".svg";
}

/// The failures of one proof: rows that stand together.
struct Failures {
  std::uint64_t proof = 0;
  std::vector<const study::Row*> rows;
};

void draw(const Failures& failures, const study::Table& table, StudyProofs& proofs, const WorstRuns& how) {
  const auto proof = proofs.prove_thoroughly(failures.proof);
  if (!proof || Interruption::asked_for()) return;
  std::vector<OutputFile> files;
  for (const study::Row* row : failures.rows) {
    for (std::size_t i = 0; i < proof->analysis.verdicts.size(); ++i) {
      const analyzer::Verdict& verdict = proof->analysis.verdicts[i];
      if (verdict.requirement != table.requirements[row->requirement] || !has_worst_run(verdict)) continue;
      if (const auto shown = shown_run(*proof, i))
        files.push_back({file_of(how, table, *row),
                         analyzer::chart::svg(analyzer::chart::timeline(shown->run), shown->options)});
    }
  }
  if (const auto trouble = write_files(files)) throw std::runtime_error(*trouble);
}

}  // namespace

void draw_worst_runs(const study::Table& table, StudyProofs& proofs, const WorstRuns& how,
                     const Console& console) {
  std::vector<Failures> all;
  std::size_t wanted = 0;
  for (const study::Row& row : table.rows) {
    if (row.outcome != study::Outcome::fails) continue;
    const std::uint64_t proof = std::uint64_t{row.point} * table.pairs.size() + row.pair;
    if (all.empty() || all.back().proof != proof) all.push_back({proof, {}});
    all.back().rows.push_back(&row);
    ++wanted;
    std::error_code ignored;
    std::filesystem::remove(file_of(how, table, row), ignored);  // of an earlier study
  }
  {
    Progress progress(all.size(), console);
    study::run_on_cores({all.size(), how.jobs > 0 ? how.jobs : cores(),
                         [&](std::size_t i) { draw(all[i], table, proofs, how); },
                         [&progress](std::size_t done) { progress.show(done); }, Interruption::asked_for});
  }
  std::size_t drawn = 0;
  for (const study::Row& row : table.rows)
    if (row.outcome == study::Outcome::fails && std::filesystem::exists(file_of(how, table, row))) ++drawn;
  console.out << drawn << " worst runs of " << wanted << " failures drawn in " << how.folder << "\n";
  if (drawn < wanted)
    console.err
        << "pal: " << wanted - drawn
        << " failures have no chart: no single run attains a load, and some are known by a bound alone\n";
}

}  // namespace pal::program
