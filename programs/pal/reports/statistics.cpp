#include "programs/pal/reports/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "programs/pal/reports/json_text.hpp"

namespace pal::program {
namespace {

void write_line(const std::string& name, std::size_t width, const analyzer::Statistics& of,
                std::ostream& out) {
  out << fmt::format("  {:{}}  {:>9} states  {:>9} classes  {:>8.2f} s  {:>6} MB\n", name, width, of.states,
                     of.classes, of.seconds, (of.peak_memory + 999'999) / 1'000'000);
}

}  // namespace

analyzer::Statistics sum_of(const std::vector<Proof>& proofs) {
  analyzer::Statistics sum;
  for (const Proof& proof : proofs) sum += proof.analysis.statistics;
  return sum;
}

void write_statistics(const std::vector<Proof>& proofs, std::ostream& out) {
  std::size_t width = 3;
  for (const Proof& proof : proofs) {
    for (const analyzer::Verdict& verdict : proof.analysis.verdicts)
      width = std::max(width, verdict.requirement.size());
  }
  for (const Proof& proof : proofs) {
    out << proof.problem.skill << " in " << proof.problem.environment << "\n";
    for (const analyzer::Verdict& verdict : proof.analysis.verdicts)
      write_line(verdict.requirement, width, verdict.statistics, out);
  }
  write_line("all", width, sum_of(proofs), out);
}

std::string json(const analyzer::Statistics& statistics) {
  const nlohmann::ordered_json members{{"states", statistics.states},
                                       {"classes", statistics.classes},
                                       {"seconds", statistics.seconds},
                                       {"peak_bytes", statistics.peak_memory}};
  return json_text(members);
}

}  // namespace pal::program
