#include "programs/pal/reports/arithmetic.hpp"

#include <fmt/format.h>

#include <ostream>
#include <string>

#include "programs/pal/session/measure_text.hpp"

namespace pal::program {
namespace {

using Json = nlohmann::ordered_json;

std::string amount_text(const analyzer::Verdict& verdict, analyzer::Nanoseconds amount) {
  const std::string size = whole_text(figure_of(verdict.measure, Duration(amount < 0 ? -amount : amount)));
  return (amount < 0 ? "- " : "+ ") + size;
}

std::string place_text(const analyzer::Addend& addend) {
  return addend.line == 0 ? "" : fmt::format("  ({}:{})", addend.file, addend.line);
}

/// What is inside a part stands below it, with its amounts to the right of that of the whole.
void write_addends(const std::vector<analyzer::Addend>& addends, const analyzer::Verdict& verdict,
                   std::size_t depth, std::ostream& out) {
  for (const analyzer::Addend& each : addends) {
    const std::string who = each.actor.empty() ? "" : each.actor + " ";
    const std::string sum = amount_text(verdict, each.amount);
    out << fmt::format("      {:>14}  {}{}{}\n", depth == 0 ? sum : "",
                       depth == 0 ? "" : fmt::format("{:{}}{}  ", "", 2 * depth, sum.substr(2)),
                       who + each.what, place_text(each));
    write_addends(each.inside, verdict, depth + 1, out);
  }
}

Json rows_of(const std::vector<analyzer::Addend>& addends) {
  auto rows = Json::array();
  for (const analyzer::Addend& each : addends) {
    Json row = Json::object();
    row["amount_ns"] = each.amount;
    row["actor"] = each.actor;
    row["what"] = each.what;
    row["file"] = each.file;
    row["line"] = each.line;
    if (!each.inside.empty()) row["inside"] = rows_of(each.inside);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

void write_arithmetic(const analyzer::Verdict& verdict, std::ostream& out) {
  write_addends(verdict.addends, verdict, 0, out);
}

Json arithmetic_json(const analyzer::Verdict& verdict) {
  return rows_of(verdict.addends);
}

}  // namespace pal::program
