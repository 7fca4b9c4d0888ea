// A study as its file says it: which skills, environments and requirements, and which figures take which
// values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pal::study {

/// One value of a figure. `changes` are made to the environment, in the words of `pal whatif --set`.
struct Choice {
  std::string label;  // "20 ms"
  std::vector<std::string> changes;
};

/// A figure that is varied. It has at least one choice, and no two of the same label.
struct Figure {
  std::string name;
  std::vector<Choice> choices;
  int line = 0;  // of the study file
};

/// A picture over one figure (slack) or two (heat map), by their indices.
struct PlotWish {
  std::vector<std::size_t> over;
};

struct Study {
  std::string title;
  std::vector<std::string> files;         // as written, relative to the study file
  std::vector<std::string> environments;  // likewise
  std::vector<std::string> skills;        // names; empty: all
  std::vector<std::string> environment_names;
  std::vector<std::string> requirements;
  std::vector<Figure> figures;
  std::vector<PlotWish> plots;
  std::string analysis = "auto";
  std::size_t max_states = 1'000'000;
  double seconds = 0;  // of one proof; 0: as long as it takes
};

/// Why a text is no study.
struct Refusal {
  int line = 0;  // 0: of the whole
  std::string what;
  std::string hint;
};

/// Reads TOML (docs/reference/studies.md). Nothing large is made: ranges are counted first.
std::variant<Study, Refusal> read_study(std::string_view text);

}  // namespace pal::study
