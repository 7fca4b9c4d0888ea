// Numbers for statements whose text does not fit into their bars, with the key to them.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "analyzer/chart/layer.hpp"
#include "analyzer/chart/time_scale.hpp"

namespace pal::analyzer::chart {

constexpr Length bar_font = 85;

/// Whether the bar is wide enough for its text.
bool text_fits(const Bar& bar, std::int64_t shift_ns, const TimeScale& scale);

class Numbering {
 public:
  struct Entry {
    int number = 0;
    std::string lane;
    std::string text;
  };

  Numbering() = default;
  /// Numbers the statements that the scale shows and that do not fit into one of their bars. The numbers
  /// begin at 1. They go by lane from top to bottom, then as in the text.
  Numbering(const std::vector<Layer>& layers, const TimeScale& scale);

  /// 0: the statement has no number.
  int number(const Lane& lane, const Bar& bar) const;

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  /// Lane, file, line, text. The file without its folder, because folders may differ between two runs of one
  /// program.
  using Key = std::tuple<std::string, std::string, int, std::string>;
  static Key key(const Lane& lane, const Bar& bar);
  std::map<Key, int> numbers_;
  std::vector<Entry> entries_;
};

}  // namespace pal::analyzer::chart
