#include "tests/run/skills/bench/table.hpp"

#include <fmt/format.h>

#include <ostream>

namespace pal::test {

bool write(const std::vector<Figure>& figures, std::ostream& out) {
  bool all = true;
  out << "| skill | what | to reach | measured | reached | worst observed / bound |\n";
  out << "| --- | --- | --- | --- | --- | --- |\n";
  for (const Figure& figure : figures) {
    const bool within = figure.of_bound <= 1;
    out << fmt::format(
        "| {} | {} | {} | {} | {} | {} |\n", figure.skill, figure.what, figure.to_reach, figure.measured,
        figure.to_reach == "reported" ? ""
        : figure.reached              ? "yes"
                                      : "**no**",
        figure.of_bound == 0 ? "" : fmt::format("{:.2f}{}", figure.of_bound, within ? "" : " **beyond**"));
    all = all && figure.reached && within;
  }
  return all;
}

}  // namespace pal::test
