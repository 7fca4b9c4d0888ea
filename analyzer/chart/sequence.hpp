// A run as a message sequence chart. Each module has a line down the page, and the messages follow from top
// to bottom. Needs no times; the order alone is drawn (after ITU-T Z.120, which robot engineers know from
// their manuals).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pal::analyzer::chart {

struct SequenceLane {
  std::string name;  // "SM1.2"
  std::string kind;  // "skill module"; "device"
  bool device = false;
};

/// Leaves its sender in one row and reaches its receiver in the same or a later one.
struct SequenceMessage {
  std::size_t from_lane = 0;
  std::size_t from_row = 0;
  std::size_t to_lane = 0;
  std::optional<std::size_t> to_row;  // none: it is never taken
  std::string label;
};

/// Something that one module does by itself.
struct SequenceNote {
  std::size_t lane = 0;
  std::size_t row = 0;
  std::string text;  // "finds pc-reach = TRUE"
};

/// Where a module stands for ever.
struct SequenceStop {
  std::size_t lane = 0;
  std::string text;   // "waits for 'Zforce' from LS1"
  std::string place;  // "touch.pal:36"
};

struct SequenceChart {
  std::string title;
  std::string subtitle;
  std::vector<SequenceLane> lanes;
  std::vector<std::string> places;  // by row: "touch.pal:36"
  std::vector<SequenceMessage> messages;
  std::vector<SequenceNote> notes;
  std::vector<SequenceStop> stops;  // below the last row
};

/// The same chart gives the same bytes. Rows and lanes must be among those of the chart.
std::string sequence_svg(const SequenceChart& chart);

}  // namespace pal::analyzer::chart
