#include "pal/driver/arithmetic.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "pal/driver/measure_text.hpp"

namespace pal::driver {
namespace {

std::string amount_text(const analyzer::Verdict& verdict, analyzer::Nanoseconds amount) {
  const std::string size = whole_text(verdict.measure, Duration(amount < 0 ? -amount : amount));
  return (amount < 0 ? "- " : "+ ") + size;
}

std::string place_text(const analyzer::Addend& addend) {
  return addend.line == 0 ? "" : fmt::format("  ({}:{})", addend.file, addend.line);
}

}  // namespace

void write_arithmetic(const analyzer::Verdict& verdict, std::ostream& out) {
  for (const analyzer::Addend& each : verdict.addends) {
    const std::string who = each.actor.empty() ? "" : each.actor + " ";
    out << fmt::format("      {:>14}  {}{}{}\n", amount_text(verdict, each.amount), who, each.what,
                       place_text(each));
  }
}

std::string arithmetic_json(const analyzer::Verdict& verdict) {
  auto rows = nlohmann::ordered_json::array();
  for (const analyzer::Addend& each : verdict.addends) {
    rows.push_back({{"amount_ns", each.amount},
                    {"actor", each.actor},
                    {"what", each.what},
                    {"file", each.file},
                    {"line", each.line}});
  }
  return rows.dump();
}

}  // namespace pal::driver
