#include "study/table.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

#include "study/cells.hpp"

namespace pal::study {
namespace {

std::string quoted_csv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string made = "\"";
  for (const char c : text) {
    if (c == '"') made += '"';
    made += c;
  }
  return made + "\"";
}

std::string quoted_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The texts of a table, each quoted once.
struct Texts {
  template <class Quote>
  Texts(const Table& table, const Quote& quote) {
    for (const Figure& figure : table.study.figures) {
      names.push_back(quote(figure.name));
      values.emplace_back();
      for (const Choice& choice : figure.choices) values.back().push_back(quote(choice.label));
    }
    for (const Pair& pair : table.pairs) {
      skills.push_back(quote(pair.skill));
      environments.push_back(quote(pair.environment));
    }
    for (const std::string& each : table.requirements) requirements.push_back(quote(each));
    for (const std::string& each : table.notes) notes.push_back(quote(each));
  }

  std::vector<std::string> names, skills, environments, requirements, notes;
  std::vector<std::vector<std::string>> values;
};

const char* measure_name(const Row& row) {
  return !row.described ? "" : row.at_least ? "least_interval" : analyzer::name(row.measure);
}

/// "fails": the choices of a point are looked up once, for all its rows.
class Choices {
 public:
  explicit Choices(const Study& study) : study_(study) {}
  const std::vector<std::size_t>& at(std::uint32_t point) {
    if (choices_.empty() || point != point_) choices_ = choices_at(study_, point);
    point_ = point;
    return choices_;
  }

 private:
  const Study& study_;
  std::uint32_t point_ = 0;
  std::vector<std::size_t> choices_;
};

std::string number(const std::optional<std::int64_t>& value, const char* none) {
  return value ? std::to_string(*value) : none;
}

std::string limit(const Row& row, const char* none) {
  return row.described ? std::to_string(row.limit) : none;
}

}  // namespace

const char* name(Outcome outcome) {
  switch (outcome) {
    case Outcome::holds:
      return "holds";
    case Outcome::fails:
      return "fails";
    case Outcome::undecided:
      return "undecided";
    case Outcome::never:
      return "never";
    case Outcome::not_checked:
      break;
  }
  return "not checked";
}

Outcome outcome_of(analyzer::VerdictState state) {
  switch (state) {
    case analyzer::VerdictState::holds:
      return Outcome::holds;
    case analyzer::VerdictState::fails:
      return Outcome::fails;
    case analyzer::VerdictState::undecided:
      return Outcome::undecided;
    case analyzer::VerdictState::never:
      return Outcome::never;
  }
  return Outcome::not_checked;
}

std::optional<std::int64_t> slack(const Row& row) {
  if (!row.bound) return std::nullopt;
  return row.at_least ? *row.bound - row.limit : row.limit - *row.bound;
}

Row row_of(const analyzer::Verdict& verdict) {
  Row row;
  row.described = true;
  row.outcome = outcome_of(verdict.state);
  row.exact = verdict.exact;
  row.at_least = verdict.at_least;
  row.measure = verdict.measure;
  row.limit = verdict.limit.count();
  if (verdict.bound) row.bound = verdict.bound->count();
  if (const auto value = analyzer::attained(verdict)) row.attained = value->count();
  return row;
}

Outcome worse(Outcome a, Outcome b) {
  const auto rank = [](Outcome each) {
    switch (each) {
      case Outcome::fails:
        return 4;
      case Outcome::not_checked:
        return 3;
      case Outcome::undecided:
        return 2;
      case Outcome::never:
        return 1;
      case Outcome::holds:
        break;
    }
    return 0;
  };
  return rank(a) >= rank(b) ? a : b;
}

void write_csv(const Table& table, std::ostream& out) {
  const Texts texts(table, quoted_csv);
  out << "point,skill,environment";
  for (const std::string& each : texts.names) out << ',' << each;
  out << ",requirement,measure,verdict,limit_ns,bound_ns,attained_ns,slack_ns,exact,note\n";
  Choices choices(table.study);
  for (const Row& row : table.rows) {
    out << row.point << ',' << texts.skills[row.pair] << ',' << texts.environments[row.pair];
    const auto& chosen = choices.at(row.point);
    for (std::size_t i = 0; i < chosen.size(); ++i) out << ',' << texts.values[i][chosen[i]];
    out << ',' << texts.requirements[row.requirement] << ',' << measure_name(row) << ',' << name(row.outcome)
        << ',' << limit(row, "") << ',' << number(row.bound, "") << ',' << number(row.attained, "") << ','
        << number(slack(row), "") << ',' << (row.exact ? "true" : "false") << ',' << texts.notes[row.note]
        << '\n';
  }
}

void write_json(const Table& table, std::ostream& out) {
  const Texts texts(table, quoted_json);
  out << "{\"format_version\": 1, \"title\": " << quoted_json(table.study.title) << ",\n \"figures\": [";
  for (std::size_t i = 0; i < texts.names.size(); ++i) {
    out << (i == 0 ? "" : ",\n  ") << "{\"name\": " << texts.names[i] << ", \"values\": [";
    for (std::size_t k = 0; k < texts.values[i].size(); ++k)
      out << (k == 0 ? "" : ", ") << texts.values[i][k];
    out << "]}";
  }
  out << "],\n \"rows\": [";
  Choices choices(table.study);
  const char* before = "\n  ";
  for (const Row& row : table.rows) {
    out << before << "{\"point\": " << row.point << ", \"skill\": " << texts.skills[row.pair]
        << ", \"environment\": " << texts.environments[row.pair] << ", \"values\": [";
    const auto& chosen = choices.at(row.point);
    for (std::size_t i = 0; i < chosen.size(); ++i) out << (i == 0 ? "" : ", ") << texts.values[i][chosen[i]];
    out << "], \"requirement\": " << texts.requirements[row.requirement] << ", \"measure\": \""
        << measure_name(row) << "\", \"verdict\": \"" << name(row.outcome)
        << "\", \"limit_ns\": " << limit(row, "null") << ", \"bound_ns\": " << number(row.bound, "null")
        << ", \"attained_ns\": " << number(row.attained, "null")
        << ", \"slack_ns\": " << number(slack(row), "null")
        << ", \"exact\": " << (row.exact ? "true" : "false") << ", \"note\": " << texts.notes[row.note]
        << '}';
    before = ",\n  ";
  }
  out << "]}\n";
}

}  // namespace pal::study
