#include "programs/pal/reports/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "pal/support/render.hpp"
#include "programs/pal/reports/arithmetic.hpp"
#include "programs/pal/reports/json_text.hpp"
#include "programs/pal/reports/statistics.hpp"

namespace pal::program {
namespace {

using State = analyzer::VerdictState;

std::string margin_text(const analyzer::Verdict& verdict) {
  if (!verdict.bound) return "";
  const Duration margin(verdict.allowed().margin(verdict.bound->count()));
  const bool over = margin < Duration::zero();
  const bool load = verdict.measure == analyzer::Requirement::Measure::load;
  // What is to spare of a load is rounded down, as its bound is rounded up.
  const Duration rounding(load && !over ? margin.count() % 100'000 : 0);
  return text(figure_of(verdict.measure, over ? -margin : margin - rounding)) + (!over ? " to spare"
                                                                                 : verdict.at_least
                                                                                     ? " too little"
                                                                                     : " too much");
}

/// Nothing for the exact analysis, which is the usual one.
std::string method_text(const analyzer::Verdict& verdict) {
  return verdict.method == analyzer::Method::exact ? "" : "  (compositional)";
}

bool any_half_open(const std::vector<Proof>& proofs) {
  return std::any_of(proofs.begin(), proofs.end(), [](const Proof& proof) { return proof.half_open; });
}

nlohmann::ordered_json json(const Unchecked& row) {
  nlohmann::ordered_json object;
  object["name"] = row.requirement;
  object["skill"] = row.skill;
  object["environment"] = row.environment;
  object["measure"] = row.measure;
  object["limit_ns"] = row.limit.count();
  object["bound_ns"] = nullptr;
  object["attained_ns"] = nullptr;
  object["exact"] = false;
  object["analysis"] = nullptr;
  object["verdict"] = "not checked";
  object["addends"] = nlohmann::ordered_json::array();
  object["reason"] = row.reason;
  return object;
}

}  // namespace

std::vector<std::string> table_rows(const analyzer::Problem& problem, const analyzer::Analysis& analysis,
                                    bool at_work) {
  std::size_t name_width = 0, measure_width = 0;
  std::vector<std::string> measures;
  for (std::size_t i = 0; i < analysis.verdicts.size(); ++i) {
    name_width = std::max(name_width, analysis.verdicts[i].requirement.size());
    measures.push_back(measure_text(problem, i));
    measure_width = std::max(measure_width, measures.back().size());
  }
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < analysis.verdicts.size(); ++i) {
    const analyzer::Verdict& verdict = analysis.verdicts[i];
    const bool open = at_work && verdict.state == State::undecided;
    rows.push_back(fmt::format(
        "  {:9}  {:{}}  {:{}}  {:>11}  of {:>7}  {}{}", open ? "open" : analyzer::name(verdict.state),
        verdict.requirement, name_width, measures[i], measure_width, bound_text(verdict),
        whole_text(verdict.allowed().figure), margin_text(verdict), method_text(verdict)));
  }
  return rows;
}

void write_table(const std::vector<Proof>& proofs, bool explain, std::ostream& out) {
  for (const Proof& proof : proofs) {
    out << heading_of(proof) << "\n";
    const std::vector<std::string> rows = table_rows(proof.problem, proof.analysis, false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out << rows[i] << "\n";
      if (explain) write_arithmetic(proof.analysis.verdicts[i], out);
    }
  }
  if (any_half_open(proofs)) out << "  " << half_open_text << "\n";
}

void write_unchecked(const std::vector<Unchecked>& not_checked, std::ostream& out) {
  std::string heading;
  for (const Unchecked& row : not_checked) {
    if (row.skill.empty()) continue;  // said by the command
    const std::string now = row.environment.empty() ? row.skill : row.skill + " in " + row.environment;
    if (now != heading) out << now << "\n";
    heading = now;
    out << "  not checked  " << (row.requirement.empty() ? "" : row.requirement + ": ") << row.reason << "\n";
  }
}

std::string json(const std::vector<Proof>& proofs, const std::vector<Unchecked>& not_checked,
                 const Session& session, bool statistics) {
  nlohmann::ordered_json document;
  document["format_version"] = 1;
  document["diagnostics"] =
      nlohmann::ordered_json::parse(render_json(session.diagnostics.sorted(), session.sources));
  document["not_kept"] = session.diagnostics.not_kept().sum();
  if (any_half_open(proofs)) document["windows"] = half_open_text;
  document["requirements"] = nlohmann::ordered_json::array();
  for (const Proof& proof : proofs) {
    for (const analyzer::Verdict& verdict : proof.analysis.verdicts) {
      nlohmann::ordered_json row;
      row["name"] = verdict.requirement;
      row["skill"] = proof.problem.skill;
      if (!proof.file.empty()) row["skill_file"] = proof.file;
      row["environment"] = proof.problem.environment;
      row["measure"] = verdict.at_least ? "least_interval" : analyzer::name(verdict.measure);
      row["limit_ns"] = verdict.limit.count();
      row["bound_ns"] =
          verdict.bound ? nlohmann::ordered_json(verdict.bound->count()) : nlohmann::ordered_json();
      const auto least = attained(verdict);
      row["attained_ns"] = least ? nlohmann::ordered_json(least->count()) : nlohmann::ordered_json();
      row["exact"] = verdict.exact;
      row["analysis"] = analyzer::name(verdict.method);
      row["verdict"] = analyzer::name(verdict.state);
      if (verdict.loop_growth && verdict.loop_growth->loop.valid()) {
        const analyzer::ProgramLoop& loop = proof.problem.loops[verdict.loop_growth->loop];
        row["grows_in_loop"] = {{"file", loop.file}, {"line", loop.line}};
      }
      row["taken_as_lost"] = nlohmann::ordered_json::array();
      for (const analyzer::LostEvents& lost : verdict.taken_as_lost) {
        const analyzer::Device& device = proof.problem.devices[lost.device];
        row["taken_as_lost"].push_back({{"device", device.name},
                                        {"message", proof.problem.channels[device.event].message},
                                        {"lost", lost.lost},
                                        {"in", lost.in}});
      }
      row["addends"] = arithmetic_json(verdict);
      if (statistics) row["statistics"] = nlohmann::ordered_json::parse(json(verdict.statistics));
      document["requirements"].push_back(std::move(row));
    }
  }
  for (const Unchecked& row : not_checked) {
    if (!row.requirement.empty()) document["requirements"].push_back(json(row));
  }
  document["not_checked"] = nlohmann::ordered_json::array();
  for (const Unchecked& row : not_checked)
    document["not_checked"].push_back({{"name", row.requirement},
                                       {"skill", row.skill},
                                       {"environment", row.environment},
                                       {"reason", row.reason}});
  if (statistics) document["statistics"] = nlohmann::ordered_json::parse(json(sum_of(proofs)));
  return json_text(document, 2) + "\n";
}

}  // namespace pal::program
