// An operation against what is known of a cell: its sensors, the figures that its skills report, its skills.

#include "operations/check.hpp"
#include "operations/check_codes.hpp"
#include "operations/check_skills.hpp"
#include "operations/check_values.hpp"
#include "operations/codes.hpp"
#include "operations/cure.hpp"
#include "operations/graph.hpp"
#include "operations/suggestion.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

/// Names that must be among those that the cell knows.
class KnownNames {
 public:
  KnownNames(const Sensors& known, Diagnostics& diagnostics) : known_(known), diagnostics_(diagnostics) {
    for (const auto& [name, sensor] : known) {
      names_.push_back(name);
      list_ += (list_.empty() ? "there is " : ", ") + name;
    }
  }
  /// The sensor or figure; null, with a finding, if there is none.
  const Sensor* find(const std::string& name, SourceSpan where, FindingWith<2> missing) {
    const auto found = known_.find(name);
    if (found != known_.end()) return &found->second;
    const auto near = suggestions_.nearest_to(name, names_);
    auto& finding = diagnostics_.report(missing, where, name, list_.empty() ? "there is none" : list_);
    finding.suggest(near);
    // A figure's name stands within the value that the place is of.
    if (where.end - where.begin == name.size() + 2) finding.fix = renamed(where, near);
    return nullptr;
  }

 private:
  const Sensors& known_;
  Diagnostics& diagnostics_;
  Suggestions suggestions_;
  std::vector<std::string> names_;
  std::string list_;
};

/// The checks of what icons read: sensors, and figures that skills have reported.
class ReadingChecks {
 public:
  ReadingChecks(const Cell& cell, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    if (cell.sensors) sensors_.emplace(*cell.sensors, diagnostics);
    if (cell.figures) figures_.emplace(*cell.figures, diagnostics);
  }

  void check(const Operation& operation, const Icon& icon) {
    if (sensors_ && !icon.sensor.empty()) sensor(icon.sensor, icon.subject);
    for (const Condition& condition : icon.conditions) {
      const Sensor* read = nullptr;
      if (sensors_ && !condition.sensor.empty()) read = sensor(condition.sensor, condition.subject);
      if (condition.sensor.empty()) figure(condition.value);
      if (condition.at_least) compare(operation, *condition.at_least, read);
      if (condition.at_most) compare(operation, *condition.at_most, read);
      for (const Amount& limit : icon.limits) compare(operation, limit, read);
    }
    for (const Parameter& parameter : icon.parameters) figure({0, parameter.where, parameter.source});
    for (const auto* amount : {&icon.repeat, &icon.time_limit, &icon.seconds, &icon.timeout, &icon.code})
      if (*amount) figure(**amount);
  }

 private:
  const Sensor* sensor(const std::string& name, SourceSpan where) {
    return sensors_->find(name, where, Finding::no_such_sensor);
  }
  const Sensor* figure(const Amount& amount) {
    if (!figures_ || amount.source.kind != Source::Kind::output) return nullptr;
    return figures_->find(amount.source.name, amount.where, Finding::no_such_figure);
  }
  /// What is compared with a sensor has its unit.
  void compare(const Operation& operation, const Amount& amount, const Sensor* read) {
    const Sensor* reported = figure(amount);
    const pan::Parameter* argument =
        amount.source.kind == Source::Kind::argument ? find_argument(operation, amount.source.name) : nullptr;
    if (read == nullptr || (reported == nullptr && argument == nullptr)) return;
    const std::string& unit = reported != nullptr ? reported->unit : argument->unit;
    if (unit == read->unit) return;
    const auto in_words = [](const std::string& text) {
      return text.empty() ? "a plain number" : "in " + text;
    };
    diagnostics_.report(Finding::unit_of_sensor, amount.where, to_text(amount), in_words(unit),
                        in_words(read->unit));
  }

  Diagnostics& diagnostics_;
  std::optional<KnownNames> sensors_, figures_;
};

}  // namespace

bool check_cell(const Program& program, const Cell& cell, Diagnostics& diagnostics, const Stop& stop) {
  const auto stopped = [&stop] { return stop && stop(); };
  if (stopped()) return false;
  const Graph graph(program);
  ReadingChecks readings(cell, diagnostics);
  for (const Operation& operation : program.operations) {
    if (stopped()) return false;
    for (const Icon& icon : operation.icons) readings.check(operation, icon);
  }
  if (!cell.skills) return true;
  SkillChecks skills(graph, cell, diagnostics);
  const PossibleCodes codes = possible_codes(graph, *cell.skills, stop);
  if (!codes.complete) return false;
  for (std::size_t o = 0; o < program.operations.size(); ++o) {
    if (stopped()) return false;
    skills.check_arguments(o);
    for (std::size_t i = 0; i < program.operations[o].icons.size(); ++i) {
      const Icon& icon = graph.icon({o, i});
      if (icon.kind == IconKind::skill || icon.kind == IconKind::sub_operation) skills.check({o, i}, icon);
      check_codes(graph, {o, i}, *cell.skills, codes, diagnostics);
    }
  }
  return true;
}

void check_parameters(const Graph& graph, Place at, const Icon& changed, const Cell& cell,
                      Diagnostics& diagnostics) {
  Suggestions suggestions;
  check_values(graph, at, changed, suggestions, diagnostics);
  ReadingChecks(cell, diagnostics).check(graph.program().operations[at.operation], changed);
  if (cell.skills) SkillChecks(graph, cell, diagnostics).check(at, changed);
}

}  // namespace pal::operations
