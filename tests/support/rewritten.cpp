#include "tests/support/rewritten.hpp"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <sstream>
#include <vector>

#include "tests/support/lines.hpp"

namespace pal::test {
namespace {

/// Without their indentation, and without empty lines.
Lines bare_lines_of(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string::npos) lines.push_back(line.substr(first));
  }
  return lines;
}

bool begins_module(const std::string& line) {
  static const std::regex head(
      R"((Sensor Driver|Logical Sensor|Machine Controller|Contingency Module|Skill Module):.*)");
  return std::regex_match(line, head);
}

/// Declarations, skill, modules and environment, each with all its lines.
std::vector<Lines> parts_of(const Lines& lines) {
  std::vector<Lines> parts;
  std::string end;  // of the part that is being read; "": a module, or none
  bool module = false;
  for (const std::string& line : lines) {
    const bool alone = line.starts_with("MESSAGE ") || line.starts_with("CONDITION ") ||
                       (line.starts_with("DEVICE ") && end.empty());
    const bool skill = line.starts_with("SKILL ") && end.empty() && !line.starts_with("SKILL METHOD");
    const bool environment = line.starts_with("ENVIRONMENT ");
    const bool starts = alone || skill || environment || begins_module(line);
    if ((starts && end.empty()) || parts.empty()) {
      parts.emplace_back();
      module = begins_module(line);
      if (skill) end = "END SKILL";
      if (environment) end = "END ENVIRONMENT";
    } else if (end.empty() && !module) {
      parts.emplace_back();
    }
    parts.back().push_back(line);
    if (line == end) end.clear();
  }
  return parts;
}

/// The body of a loop without end, before it. One in which blocks stand keeps their names only alone.
void unroll(Lines& lines, std::mt19937_64& engine) {
  Lines made;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == "REPEAT" && engine() % 2 == 0) {
      int depth = 0;
      std::size_t last = i;
      bool blocks = false;
      for (; last < lines.size(); ++last) {
        depth += lines[last] == "REPEAT" ? 1 : 0;
        depth -= lines[last].starts_with("UNTIL(") ? 1 : 0;
        blocks = blocks || lines[last] == "CONCURRENT" || lines[last].starts_with("Execute");
        if (depth == 0) break;
      }
      if (last < lines.size() && lines[last] == "UNTIL( forever )" && !blocks)
        made.insert(made.end(), lines.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    lines.begin() + static_cast<std::ptrdiff_t>(last));
    }
    made.push_back(lines[i]);
  }
  lines = std::move(made);
}

std::string renamed(const std::string& text) {
  static const std::regex name(R"(\b(SD|LS|MC|SM|CM)([0-9]+)\b)");
  std::string made;
  auto from = text.begin();
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
    made.append(from, (*at)[0].first);
    const std::string kind = (*at)[1];
    const char first = kind == "SD"   ? 'Y'
                       : kind == "LS" ? 'X'
                       : kind == "MC" ? 'B'
                       : kind == "SM" ? 'Z'
                                      : 'A';
    made += first + std::to_string(90 - std::stoi((*at)[2]));
    from = (*at)[0].second;
  }
  return made.append(from, text.end());
}

}  // namespace

std::string rewritten(const std::string& text, std::mt19937_64& engine) {
  std::vector<Lines> parts = parts_of(bare_lines_of(text));
  std::shuffle(parts.begin(), parts.end(), engine);
  Lines lines;
  const bool unrolls = engine() % 2 == 0;
  for (Lines& part : parts) {
    if (part.front().starts_with("ENVIRONMENT ") && part.size() > 2)
      std::shuffle(part.begin() + 1, part.end() - 1, engine);
    if (unrolls && begins_module(part.front())) unroll(part, engine);
    lines.insert(lines.end(), part.begin(), part.end());
  }
  return engine() % 2 == 0 ? joined(lines) : renamed(joined(lines));
}

}  // namespace pal::test
