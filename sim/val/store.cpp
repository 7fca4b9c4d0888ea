#include "sim/val/store.hpp"

#include <cstdio>
#include <sstream>

#include "sim/val/error.hpp"
#include "sim/val/expression.hpp"

namespace pal::sim::val {
namespace {

// One line between a section's head and its .END.
void read_entry(const std::string& section, const std::string& program, const std::string& text,
                Store& store) {
  if (section == "PROGRAM") {
    store.programs[program].push_back(text.substr(text.find_first_not_of(" \t")));
    return;
  }
  Line line(text);
  const std::string name = line.name();
  const auto figure = [&] {
    line.take(',');
    const std::optional<double> value = line.literal();
    if (!value) throw Error("a number is missing");
    return *value;
  };
  if (section == "REALS") {
    store.reals[name] = figure();
  } else {
    Figures figures{};
    for (double& value : figures) value = figure();
    store.locations[name] = pose_of(figures);
  }
  line.end();
}

}  // namespace

std::vector<StoreProblem> read_store(std::string_view text, Store& store) {
  std::istringstream in{std::string(text)};
  std::string section, program;
  int number = 0, opened = 0;
  for (std::string row; std::getline(in, row);) {
    ++number;
    row = row.substr(0, row.find(';'));
    while (!row.empty() && (row.back() == '\r' || row.back() == ' ' || row.back() == '\t')) row.pop_back();
    if (row.find_first_not_of(" \t") == std::string::npos) continue;
    try {
      if (row.front() != '.') {
        if (section.empty())
          return {{number, "the line stands in no section (.LOCATIONS, .REALS or .PROGRAM)"}};
        read_entry(section, program, row, store);
        continue;
      }
      Line line(row.substr(1));
      const std::string head = line.word().value_or("");
      if (head == "END") {
        if (section.empty()) return {{number, ".END closes no section"}};
        section.clear();
      } else if (!section.empty()) {
        return {{number, "the section of line " + std::to_string(opened) + " has no .END"}};
      } else if (head == "LOCATIONS" || head == "REALS" || head == "PROGRAM") {
        section = head;
        opened = number;
        if (head == "PROGRAM") store.programs[program = line.name()].clear();
      } else {
        return {{number, "no section is called '" + row + "'"}};
      }
      if (line.take('(')) line.expect(')');
      line.end();
    } catch (const Error& error) {
      return {{number, error.shown()}};
    }
  }
  if (!section.empty()) return {{opened, "the section has no .END"}};
  return {};
}

std::string write_store(const Store& store) {
  std::string text;
  std::array<char, 160> row{};
  if (!store.locations.empty()) {
    text += ".LOCATIONS\n";
    for (const auto& [name, pose] : store.locations) {
      const Figures f = figures_of(pose);
      std::snprintf(row.data(), row.size(), "%-20s %11.4f %11.4f %11.4f %10.5f %10.5f %10.5f\n", name.c_str(),
                    f[0], f[1], f[2], f[3], f[4], f[5]);
      text += row.data();
    }
    text += ".END\n";
  }
  if (!store.reals.empty()) {
    text += ".REALS\n";
    for (const auto& [name, value] : store.reals) {
      std::snprintf(row.data(), row.size(), "%-20s %.10g\n", name.c_str(), value);
      text += row.data();
    }
    text += ".END\n";
  }
  for (const auto& [name, lines] : store.programs) {
    text += ".PROGRAM " + name + "()\n";
    for (const std::string& line : lines) text += "  " + line + "\n";
    text += ".END\n";
  }
  return text;
}

}  // namespace pal::sim::val
