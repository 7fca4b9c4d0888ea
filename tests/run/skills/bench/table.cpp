#include "tests/run/skills/bench/table.hpp"

#include <fmt/format.h>

#include <ostream>

namespace pal::test {

namespace {

std::string of_bound(const Figure& figure) {
  if (figure.of_bound == 0) return "";
  return fmt::format("{:.2f}{}", figure.of_bound, figure.of_bound <= 1 ? "" : " **beyond**");
}

std::string missed(const AlterCycles& alter) {
  if (alter.asked == 0) return "";  // the skill does not use ALTER
  return fmt::format("{} of {}{}", alter.missed, alter.asked, alter.missed == 0 ? "" : " **missed**");
}

}  // namespace

bool write(const std::vector<Figure>& figures, std::ostream& out) {
  bool all = true;
  out << "| skill | what | to reach | measured | reached | worst observed / bound | ALTER cycles missed |\n";
  out << "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Figure& figure : figures) {
    out << fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", figure.skill, figure.what, figure.to_reach,
                       figure.measured,
                       figure.to_reach == "reported" ? ""
                       : figure.reached              ? "yes"
                                                     : "**no**",
                       of_bound(figure), missed(figure.alter));
    all = all && figure.reached && figure.of_bound <= 1 && figure.alter.missed == 0;
  }
  return all;
}

}  // namespace pal::test
