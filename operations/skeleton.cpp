#include "operations/skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace pal::operations {
namespace {

std::string name_of(const std::string& wanted) {
  std::string name;
  for (const char c : wanted) {
    const auto sign = static_cast<unsigned char>(c);
    if (std::isalnum(sign) != 0) {
      name += static_cast<char>(std::tolower(sign));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) name = "skill-" + name;
  return name;
}

std::string quoted(const std::string& text, const char* otherwise) {
  std::string result = text;
  std::replace(result.begin(), result.end(), '"', '\'');
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = ' ';
  return "\"" + (result.empty() ? std::string(otherwise) : result) + "\"";
}

std::string parameter_of(const pan::Parameter& each) {
  const std::string words = quoted(each.description, "TODO: what it is");
  const std::string head = "  PARAMETER " + name_of(each.name) + " : ";
  switch (each.type) {
    case pan::ScalarType::text:
      return fmt::format("{}TEXT DEFAULT {} {}\n", head, quoted(each.default_text, ""), words);
    case pan::ScalarType::boolean:
      return fmt::format("{}BOOLEAN DEFAULT {} {}\n", head, each.default_value != 0 ? "TRUE" : "FALSE",
                         words);
    default:
      break;
  }
  const bool whole = each.type == pan::ScalarType::integer;
  return fmt::format("{}{}{}{} DEFAULT {} RANGE {} TO {} {}\n", head, whole ? "INTEGER" : "REAL",
                     each.unit.empty() ? "" : " ", each.unit, each.default_value, each.low, each.high, words);
}

/// "ends-2 AND NOT ends-1": it, and none of those before it.
std::string only(const std::vector<const Way*>& ends, std::size_t which) {
  std::string text = which < ends.size() ? fmt::format("ends-{}", ends[which]->codes.front()) : std::string();
  for (std::size_t i = 0; i < std::min(which, ends.size()); ++i)
    text += fmt::format("{}NOT ends-{}", text.empty() ? "" : " AND ", ends[i]->codes.front());
  return text;
}

}  // namespace

std::string skeleton_name(const Icon& planned) {
  return name_of(planned.skill);
}

std::string skeleton_of(const Icon& planned) {
  std::string normal;
  int greatest = 0;
  std::vector<const Way*> ends;  // by contingencies, numbered as they come
  for (const Way& each : planned.ways) {
    greatest = std::max(greatest, each.codes.front());
    if (each.codes.front() == 0) {
      normal = each.text;
    } else {
      ends.push_back(&each);
    }
  }
  const std::string name = skeleton_name(planned);
  std::string out = fmt::format(
      "# {}: a skeleton, written from the planned skill of an operation. It can be checked, and does nothing "
      "yet.\n",
      name);
  for (const Way* each : ends)
    out += fmt::format("CONDITION ends-{} {}\n", each->codes.front(),
                       quoted("TODO: by what one knows: " + each->text, ""));
  out +=
      fmt::format("{}SKILL {}\n  DESCRIPTION {}\n  PRECONDITION \"TODO: what must hold before it runs.\"\n",
                  ends.empty() ? "" : "\n", name, quoted(planned.note, "TODO: what it does."));
  out += "\n  SKILL METHOD Method\n  MODEL DATA NONE\n";
  for (std::size_t i = 0; i < ends.size(); ++i)
    out += fmt::format("  CONTINGENCY {0} {1} METHOD Contingency{0}\n", i + 1, quoted(ends[i]->text, ""));
  if (!planned.planned.empty()) out += "\n";
  for (const pan::Parameter& each : planned.planned) out += parameter_of(each);
  out += fmt::format("\n  COMPLETION 0 NORMAL {}\n", quoted(normal, "TODO: what holds at its normal end."));
  for (std::size_t i = 0; i < ends.size(); ++i)
    out += fmt::format("  COMPLETION {} CONTINGENCY {} {}\n", ends[i]->codes.front(), i + 1,
                       quoted(ends[i]->text, ""));
  out += fmt::format("  COMPLETION {} ERROR \"Any other error; the robot comes to rest.\"\nEND SKILL\n",
                     greatest + 1);

  out += "\nSkill Module: Method\n  ACTIVITY work\nBEGIN\n  WTM( Coordinator )\n  work\n";
  for (const Way* each : ends) out += fmt::format("  SPC( ends-{} )\n", each->codes.front());
  if (ends.empty()) {
    out += "  TXM( Completion Protocol 0 )\n";
  } else {
    out += "  CASE\n";
    for (std::size_t i = 0; i < ends.size(); ++i)
      out += fmt::format("    ( {} ):\n      Execute Contingency{}\n      TXM( Completion Protocol {} )\n",
                         only(ends, i), i + 1, ends[i]->codes.front());
    out +=
        fmt::format("    ( {} ):\n      TXM( Completion Protocol 0 )\n  END CASE\n", only(ends, ends.size()));
  }
  out += "END\n";
  for (std::size_t i = 1; i <= ends.size(); ++i)
    out += fmt::format(
        "\nContingency Module: Contingency{0}\n  ACTIVITY give-way-{0}\nBEGIN\n  give-way-{0}\nEND\n", i);
  return out;
}

}  // namespace pal::operations
