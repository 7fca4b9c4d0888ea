#include "pal/syntax/parse_dot.hpp"

#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/dot/contents.hpp"
#include "pal/syntax/dot/graph.hpp"
#include "pal/syntax/dot/structure.hpp"
#include "pal/syntax/dot/words.hpp"

namespace pal::syntax {

namespace {

constexpr const char* known_format = "1";

void check_format(const DotGraph& graph, Diagnostics& diagnostics) {
  const DotValue* format = graph.values.find("pal_format");
  if (format == nullptr || format->text == known_format) return;
  diagnostics.report(Finding::unknown_format, format->where, known_format);
  throw Reported{};
}

/// What the template of the module says beside its activities.
void read_template(const DotGraph& graph, DotWords& words, ModuleUnit& unit) {
  if (const DotValue* texts = graph.values.find("pal_description")) unit.descriptions = words.texts(*texts);
  SensorTemplate& sensor = unit.sensor;
  const auto slot = [&](const char* name) {
    const DotValue* value = graph.values.find(name);
    if (value != nullptr && !sensor.where.valid()) sensor.where = value->where;
    return value;
  };
  if (const DotValue* names = slot("pal_drivers")) sensor.drivers = words.slot(*names);
  if (const DotValue* texts = slot("pal_method")) sensor.methods = words.texts(*texts);
  if (const DotValue* names = slot("pal_returns")) sensor.returns = words.slot(*names);
}

ModuleUnit read_module(const DotGraph& graph, Diagnostics& diagnostics) {
  check_format(graph, diagnostics);
  DotWords words(diagnostics);
  ModuleUnit unit;
  const DotValue* name = graph.values.find("pal_module");
  if (name == nullptr) {
    diagnostics.report(Finding::graph_names_no_module, graph.where);
    throw Reported{};
  }
  unit.name = words.name(*name);
  if (const DotValue* kind = graph.values.find("pal_module_kind")) unit.kind = words.module_kind(*kind);
  read_template(graph, words, unit);
  unit.has_body = true;
  unit.where = graph.where;
  unit.end = graph.where;
  DotContents contents = read_contents(graph, diagnostics);
  unit.activities = std::move(contents.activities);
  unit.body = read_structure(graph, contents, diagnostics);
  return unit;
}

}  // namespace

Tree parse_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto errors_before = diagnostics.errors();
  Tree tree;
  tree.file = file;
  if (const auto graph = read_dot(sources, file, diagnostics)) {
    if (const DotValue* uses = graph->values.find("pal_uses")) {
      for (const DotValue& path : dot_parts(*uses)) tree.units.emplace_back(Uses{path.text, path.where, {}});
    }
    try {
      tree.units.emplace_back(read_module(*graph, diagnostics));
    } catch (const Reported&) {
      // What is wrong has been said.
    }
  }
  tree.complete = diagnostics.errors() == errors_before;
  tree.lost = !tree.complete;
  return tree;
}

}  // namespace pal::syntax
