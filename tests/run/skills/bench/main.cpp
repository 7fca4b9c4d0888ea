// bench_skills [SKILL…]: measures the skills in physics and prints the table of docs/skills.md. Ends with 1
// if a figure is not reached. bench_skills causes: prints the figures again, each time without one of their
// causes.
#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <span>
#include <string_view>

#include "tests/run/skills/bench/causes.hpp"
#include "tests/run/skills/bench/table.hpp"

int main(int count, char** arguments) {
  using namespace pal::test;
  struct Bench {
    std::string_view skill;
    std::vector<Figure> (*measure)();
  };
  constexpr std::array benches{Bench{"touch", measure_touch},
                               Bench{"press", measure_press},
                               Bench{"rub", measure_rub},
                               Bench{"standoff", measure_standoff},
                               Bench{"align", measure_align},
                               Bench{"follow-edge", measure_follow_edge},
                               Bench{"moves", measure_moves},
                               Bench{"transfers", measure_transfers},
                               Bench{"palletize", measure_palletize}};
  const std::span wanted(arguments + 1, static_cast<std::size_t>(count - 1));
  try {
    if (wanted.size() == 1 && wanted[0] == std::string_view("causes")) {
      write_causes(std::cout);
      return 0;
    }
    std::vector<Figure> figures;
    for (const Bench& bench : benches) {
      const auto named = [&](const char* name) { return name == bench.skill; };
      if (!wanted.empty() && std::none_of(wanted.begin(), wanted.end(), named)) continue;
      for (Figure& figure : bench.measure()) figures.push_back(std::move(figure));
    }
    return write(figures, std::cout) ? 0 : 1;
  } catch (const std::exception& problem) {
    std::cerr << "bench_skills: " << problem.what() << '\n';
    return 2;
  }
}
