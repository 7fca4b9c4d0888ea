// The result of a study: a row for each requirement of each proof, as CSV and JSON.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/verdict/verdict.hpp"
#include "study/study_file.hpp"

namespace pal::study {

/// A verdict, or that there is none. Only `holds` is good.
enum class Outcome : std::uint8_t { holds, fails, undecided, never, not_checked };

/// "holds", …, "not checked".
const char* name(Outcome outcome);
Outcome outcome_of(analyzer::VerdictState state);

/// One requirement in one proof. Small: there may be a million.
struct Row {
  std::uint32_t point = 0;        // choices_at
  std::uint32_t pair = 0;         // in Table::pairs
  std::uint32_t requirement = 0;  // in Table::requirements
  std::uint32_t note = 0;         // in Table::notes
  Outcome outcome = Outcome::not_checked;
  bool described = false;  // measure and limit are known
  bool exact = false;
  bool at_least = false;
  analyzer::Requirement::Measure measure = analyzer::Requirement::Measure::age;
  std::int64_t limit = 0;  // nanoseconds; load: in a second; loss: a number
  std::optional<std::int64_t> bound;
  std::optional<std::int64_t> attained;
};

/// How far the bound is from the limit, above 0 if it is on the good side; nothing without a bound.
std::optional<std::int64_t> slack(const Row& row);

/// A skill in an environment.
struct Pair {
  std::string skill;
  std::string environment;
};

/// Rows are in the order of points, then pairs, then the skill's requirements.
struct Table {
  Study study;  // title, figures and plots
  std::vector<Pair> pairs;
  std::vector<std::string> requirements;
  std::vector<std::string> notes{""};
  std::vector<Row> rows;
};

/// The row of a verdict; its names and place are still to be set.
Row row_of(const analyzer::Verdict& verdict);

/// The worse of two: a failure, then what is not known, then what says nothing, then what holds.
Outcome worse(Outcome a, Outcome b);

/// A line of names, then a line each row. Fields with a comma, a quotation mark or a line's end are quoted
/// (RFC 4180).
void write_csv(const Table& table, std::ostream& out);

/// {"format_version", "title", "figures": [{"name", "values"}], "rows": [{…}]} (docs/reference/studies.md).
void write_json(const Table& table, std::ostream& out);

/// Counts by skill and by value, and the tightest bound of each requirement: Markdown.
void write_summary(const Table& table, std::ostream& out);

}  // namespace pal::study
