// A study in a page of Markdown.
#include <algorithm>
#include <array>
#include <map>
#include <ostream>

#include "pal/support/duration_text.hpp"
#include "study/cells.hpp"
#include "study/table.hpp"

namespace pal::study {
namespace {

using Measure = analyzer::Requirement::Measure;

/// Proofs by their worst outcome.
using Counts = std::array<std::size_t, 5>;

std::string escaped(const std::string& text) {
  std::string made;
  for (const char c : text) {
    if (c == '|' || c == '\\' || c == '*' || c == '_' || c == '<') made += '\\';
    made += c == '\n' ? ' ' : c;
  }
  return made;
}

std::string amount(const Row& row, std::int64_t value) {
  if (row.measure == Measure::loss) return std::to_string(value);
  if (row.measure != Measure::load) return (value < 0 ? "-" : "") + to_text(Duration(std::abs(value)));
  // Nanoseconds in a second; a hundredth of a percent is 100,000 of them. What is to spare is rounded down.
  const std::int64_t hundredths = value / 100'000 - (value < 0 && value % 100'000 != 0 ? 1 : 0);
  const std::int64_t whole = std::abs(hundredths);
  const std::string fraction = std::to_string(whole % 100);
  return (value < 0 ? "-" : "") + std::to_string(whole / 100) + "." + (fraction.size() < 2 ? "0" : "") +
         fraction + " %";
}

void write_counts(const std::string& heading, const std::vector<std::string>& names,
                  const std::vector<Counts>& counts, std::ostream& out) {
  out << "| " << heading
      << " | all hold | some fails | some undecided | some measures nothing | not checked |\n"
         "| --- | ---: | ---: | ---: | ---: | ---: |\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    out << "| " << escaped(names[i]);
    for (const std::size_t count : counts[i]) out << " | " << count;
    out << " |\n";
  }
  out << "\n";
}

/// The worst outcome of each proof, in the order of the rows.
struct ProofOutcome {
  std::uint32_t point;
  std::uint32_t pair;
  Outcome outcome;
};

std::vector<ProofOutcome> proofs_of(const Table& table) {
  std::vector<ProofOutcome> proofs;
  for (const Row& row : table.rows) {
    if (proofs.empty() || proofs.back().point != row.point || proofs.back().pair != row.pair)
      proofs.push_back({row.point, row.pair, row.outcome});
    proofs.back().outcome = worse(proofs.back().outcome, row.outcome);
  }
  return proofs;
}

void write_tightest(const Table& table, std::ostream& out) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, const Row*> tightest;
  for (const Row& row : table.rows) {
    if (!slack(row)) continue;
    const Row*& kept = tightest[{row.pair, row.requirement}];
    if (kept == nullptr || *slack(row) < *slack(*kept)) kept = &row;
  }
  if (tightest.empty()) return;
  out << "## Least slack\n\n"
         "The least known slack of each requirement, and the first point that has it. A requirement that has "
         "no\n"
         "bound at some point may be worse there.\n\n"
         "| skill | environment | requirement | slack |";
  for (const Figure& figure : table.study.figures) out << " " << escaped(figure.name) << " |";
  out << "\n| --- | --- | --- | ---: |";
  for (std::size_t i = 0; i < table.study.figures.size(); ++i) out << " --- |";
  out << "\n";
  for (const auto& [key, row] : tightest) {
    const Pair& pair = table.pairs[row->pair];
    out << "| " << escaped(pair.skill) << " | " << escaped(pair.environment) << " | "
        << escaped(table.requirements[row->requirement]) << " | " << amount(*row, *slack(*row)) << " |";
    const auto choices = choices_at(table.study, row->point);
    for (std::size_t i = 0; i < choices.size(); ++i)
      out << " " << escaped(table.study.figures[i].choices[choices[i]].label) << " |";
    out << "\n";
  }
  out << "\n";
}

void write_notes(const Table& table, std::ostream& out) {
  if (table.notes.size() < 2) return;
  std::vector<std::size_t> counts(table.notes.size());
  for (const Row& row : table.rows) ++counts[row.note];
  out << "## Not checked\n\n| requirements | why |\n| ---: | --- |\n";
  for (std::size_t i = 1; i < counts.size(); ++i)
    if (counts[i] > 0) out << "| " << counts[i] << " | " << escaped(table.notes[i]) << " |\n";
  out << "\n";
}

}  // namespace

void write_summary(const Table& table, std::ostream& out) {
  const std::vector<ProofOutcome> proofs = proofs_of(table);
  out << "# " << escaped(table.study.title) << "\n\n"
      << proofs.size() << " proofs, " << table.rows.size()
      << " verdicts. A proof is one skill in one environment at one point of the study.\n\n";
  const auto count = [&proofs, &out](const std::string& heading, const std::vector<std::string>& names,
                                     const auto& index) {
    std::vector<Counts> counts(names.size());
    for (const ProofOutcome& proof : proofs) ++counts[index(proof)][static_cast<std::size_t>(proof.outcome)];
    write_counts(heading, names, counts, out);
  };
  std::vector<std::string> pairs;
  for (const Pair& pair : table.pairs) pairs.push_back(pair.skill + " in " + pair.environment);
  out << "## Skills\n\n";
  count("skill", pairs, [](const ProofOutcome& proof) { return proof.pair; });
  for (std::size_t i = 0; i < table.study.figures.size(); ++i) {
    const Figure& figure = table.study.figures[i];
    std::vector<std::string> labels;
    for (const Choice& choice : figure.choices) labels.push_back(choice.label);
    out << "## " << escaped(figure.name) << "\n\n";
    count(figure.name, labels,
          [&](const ProofOutcome& proof) { return choices_at(table.study, proof.point)[i]; });
  }
  write_tightest(table, out);
  write_notes(table, out);
}

}  // namespace pal::study
