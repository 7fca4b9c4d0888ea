#include "study/study_file.hpp"

#include <toml++/toml.h>
#include <algorithm>
#include <optional>
#include <set>

#include "pal/support/duration_text.hpp"
#include "pal/support/nearest.hpp"
#include "study/values.hpp"

namespace pal::study {
namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

[[noreturn]] void refuse(int line, std::string what, std::string hint = {}) {
  throw Refusal{line, std::move(what), std::move(hint)};
}

/// No key is passed over: one that is misspelt would change the study without a word.
void allow(const toml::table& table, const std::vector<std::string>& keys, const std::string& of) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
    const auto close = nearest(name, keys);
    std::string all;
    for (const std::string& each : keys) all += (all.empty() ? "" : ", ") + each;
    refuse(static_cast<int>(key.source().begin.line), of + " has no '" + name + "'",
           close ? "did you mean '" + *close + "'?" : "there is " + all);
  }
}

/// A text, or a whole number as text.
std::optional<std::string> scalar(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return text;
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  return std::nullopt;
}

std::string text_at(const toml::table& table, const std::string& key, const std::string& other = {}) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return other;
  const auto text = node->value_exact<std::string>();
  if (!text) refuse(line_of(*node), "'" + key + "' is no text", "write it between quotation marks");
  return *text;
}

std::optional<std::int64_t> whole_at(const toml::table& table, const std::string& key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const auto whole = node->value_exact<std::int64_t>();
  if (!whole || *whole < 0) refuse(line_of(*node), "'" + key + "' is no whole number from 0 on");
  return whole;
}

std::vector<std::string> texts_at(const toml::table& table, const std::string& key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return {};
  const toml::array* list = node->as_array();
  if (list == nullptr) refuse(line_of(*node), "'" + key + "' is no list", "write [\"…\", \"…\"]");
  if (list->empty())
    refuse(line_of(*node), "the list '" + key + "' is empty", "name something, or leave '" + key + "' out");
  std::vector<std::string> texts;
  for (const toml::node& each : *list) {
    const auto text = scalar(each);
    if (!text) refuse(line_of(each), "'" + key + "' has something that is neither a text nor a whole number");
    texts.push_back(*text);
  }
  return texts;
}

/// `{}` stands for the value.
std::string filled(const std::string& change, const std::string& value) {
  std::string made = change;
  const auto at = made.find("{}");
  if (at != std::string::npos) made.replace(at, 2, value);
  return made;
}

std::vector<Choice> named_choices(const toml::table& table, int line, const std::string& name) {
  for (const char* key : {"values", "from", "to", "step", "count", "random", "seed", "set"}) {
    if (table.contains(key))
      refuse(line, "figure '" + name + "' has choices, and '" + key + "' as well", "leave one of them out");
  }
  const toml::array* list = table.get("choice")->as_array();
  if (list == nullptr)
    refuse(line, "the choices of figure '" + name + "' are no list", "write [[figure.choice]]");
  if (list->empty()) refuse(line, "figure '" + name + "' has no value", "give it a choice");
  std::vector<Choice> choices;
  for (const toml::node& node : *list) {
    const toml::table* each = node.as_table();
    if (each == nullptr) refuse(line_of(node), "a choice is no table", "write [[figure.choice]]");
    allow(*each, {"name", "set"}, "a choice");
    Choice choice{text_at(*each, "name"), {}};
    if (choice.label.empty())
      refuse(line_of(node), "a choice of figure '" + name + "' has no name", "write name = \"…\"");
    if (const toml::array* changes = each->get_as<toml::array>("set");
        changes == nullptr || !changes->empty())
      choice.changes = texts_at(*each, "set");  // an empty list: the figures as they are
    choices.push_back(std::move(choice));
  }
  return choices;
}

Range range_of(const toml::table& table, int line, const std::string& name) {
  Range range;
  for (const auto& [key, end] : {std::pair("from", &range.from), std::pair("to", &range.to)}) {
    const toml::node* node = table.get(key);
    const auto value = node == nullptr ? std::nullopt : scalar(*node);
    if (!value)
      refuse(line, "figure '" + name + "' has no '" + key + "'",
             "give 'values', or 'from', 'to' and one of 'step' and 'count', or choices");
    *end = *value;
  }
  if (const toml::node* step = table.get("step")) range.step = scalar(*step).value_or("");
  range.count = whole_at(table, "count");
  range.random = whole_at(table, "random");
  const auto seed = whole_at(table, "seed");
  if (range.random && !seed)
    refuse(line, "figure '" + name + "' has random values without a seed",
           "write seed = 1: the same seed gives the same study again");
  if (seed && !range.random) refuse(line, "figure '" + name + "' has a seed and nothing random");
  range.seed = static_cast<std::uint64_t>(seed.value_or(0));
  return range;
}

Figure figure_of(const toml::table& table) {
  Figure figure;
  figure.line = line_of(table);
  allow(table, {"name", "values", "from", "to", "step", "count", "random", "seed", "set", "choice"},
        "a figure");
  figure.name = text_at(table, "name");
  if (figure.name.empty()) refuse(figure.line, "a figure has no name", "write name = \"DEVICE.period\"");
  if (table.contains("choice")) {
    figure.choices = named_choices(table, figure.line, figure.name);
  } else {
    std::vector<std::string> values;
    if (table.contains("values")) {
      for (const char* key : {"from", "to", "step", "count", "random", "seed"}) {
        if (table.contains(key))
          refuse(figure.line, "figure '" + figure.name + "' has values, and '" + key + "' as well",
                 "leave one of them out");
      }
      values = texts_at(table, "values");
    } else {
      auto made = values_of(range_of(table, figure.line, figure.name));
      if (const auto* wrong = std::get_if<std::string>(&made))
        refuse(figure.line, "figure '" + figure.name + "': " + *wrong);
      values = std::get<std::vector<std::string>>(std::move(made));
    }
    std::vector<std::string> set = texts_at(table, "set");
    if (set.empty()) set = {figure.name + " = {}"};
    if (std::none_of(set.begin(), set.end(),
                     [](const std::string& each) { return each.find("{}") != std::string::npos; }))
      refuse(figure.line, "'set' of figure '" + figure.name + "' does not say where its value goes",
             "write {} in its place");
    for (const std::string& value : values) {
      Choice choice{value, {}};
      for (const std::string& change : set) choice.changes.push_back(filled(change, value));
      figure.choices.push_back(std::move(choice));
    }
  }
  std::set<std::string> seen;
  for (const Choice& choice : figure.choices) {
    if (!seen.insert(choice.label).second)
      refuse(figure.line, "figure '" + figure.name + "' has '" + choice.label + "' twice", "leave one out");
  }
  return figure;
}

PlotWish plot_of(const toml::table& table, const std::vector<Figure>& figures) {
  allow(table, {"over"}, "a plot");
  PlotWish wish;
  for (const std::string& name : texts_at(table, "over")) {
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [&](const Figure& figure) { return figure.name == name; });
    if (found == figures.end())
      refuse(line_of(table), "a plot is over '" + name + "', which is no figure of this study",
             "name a figure as [[figure]] does");
    wish.over.push_back(static_cast<std::size_t>(found - figures.begin()));
  }
  if (wish.over.empty() || wish.over.size() > 2 || (wish.over.size() == 2 && wish.over[0] == wish.over[1]))
    refuse(line_of(table), "a plot is over one figure or two", "write over = [\"…\", \"…\"]");
  return wish;
}

/// Calls `each` with every table of an array of tables.
template <class Each>
void for_tables(const toml::table& table, const std::string& key, const Each& each) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  if (list == nullptr) refuse(line_of(*node), "'" + key + "' is no list of tables", "write [[" + key + "]]");
  for (const toml::node& one : *list) {
    if (!one.is_table()) refuse(line_of(one), "'" + key + "' is no list of tables", "write [[" + key + "]]");
    each(*one.as_table());
  }
}

void read_limits(const toml::table& table, Study& study) {
  allow(table, {"max-states", "timeout", "analysis"}, "[limits]");
  if (const auto states = whole_at(table, "max-states")) study.max_states = static_cast<std::size_t>(*states);
  study.analysis = text_at(table, "analysis", study.analysis);
  const std::vector<std::string> known{"auto", "thorough", "exact", "compositional"};
  if (std::find(known.begin(), known.end(), study.analysis) == known.end())
    refuse(line_of(*table.get("analysis")), "there is no analysis '" + study.analysis + "'",
           "write auto, thorough, exact or compositional");
  const std::string timeout = text_at(table, "timeout");
  if (timeout.empty()) return;
  const auto unit = timeout.find_first_not_of("0123456789. ");
  const auto digits = timeout.find_last_of("0123456789.");
  const auto time = unit == std::string::npos || digits == std::string::npos
                        ? std::variant<Duration, DurationError>(DurationError::no_unit)
                        : parse_duration(timeout.substr(0, digits + 1), timeout.substr(unit));
  const auto* length = std::get_if<Duration>(&time);
  if (length == nullptr || length->count() <= 0)
    refuse(line_of(*table.get("timeout")), "'" + timeout + "' is no length of time", "write \"90 s\"");
  study.seconds = std::chrono::duration<double>(*length).count();
}

Study study_of(const toml::table& table) {
  allow(table,
        {"title", "files", "environments", "skills", "environment-names", "requirements", "limits", "figure",
         "plot"},
        "a study");
  Study study;
  study.title = text_at(table, "title", "Study");
  study.files = texts_at(table, "files");
  if (study.files.empty()) refuse(0, "the study names no files", "write files = [\"skill.pal\"]");
  study.environments = texts_at(table, "environments");
  study.skills = texts_at(table, "skills");
  study.environment_names = texts_at(table, "environment-names");
  study.requirements = texts_at(table, "requirements");
  if (const toml::node* limits = table.get("limits")) {
    if (!limits->is_table()) refuse(line_of(*limits), "'limits' is no table", "write [limits]");
    read_limits(*limits->as_table(), study);
  }
  for_tables(table, "figure", [&](const toml::table& each) {
    Figure figure = figure_of(each);
    for (const Figure& other : study.figures) {
      if (other.name == figure.name) refuse(figure.line, "there are two figures '" + figure.name + "'");
    }
    study.figures.push_back(std::move(figure));
  });
  for_tables(table, "plot",
             [&](const toml::table& each) { study.plots.push_back(plot_of(each, study.figures)); });
  if (study.plots.empty() && study.figures.size() == 1) study.plots.push_back({{0}});
  if (study.plots.empty() && study.figures.size() >= 2) study.plots.push_back({{0, 1}});
  return study;
}

}  // namespace

std::variant<Study, Refusal> read_study(std::string_view text) {
  try {
    return study_of(toml::parse(text));
  } catch (const toml::parse_error& error) {
    return Refusal{static_cast<int>(error.source().begin.line),
                   "this is no TOML: " + std::string(error.description()),
                   "docs/reference/studies.md shows a study"};
  } catch (const Refusal& refusal) {
    return refusal;
  }
}

}  // namespace pal::study
