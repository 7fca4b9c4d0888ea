// Keeps labels from colliding: code that places a label asks here first.
#pragma once

#include <vector>

#include "analyzer/chart/svg_writer.hpp"

namespace pal::analyzer::chart {

class Labels {
 public:
  /// Whether nothing that was taken overlaps the box.
  bool free(const Box& box) const;
  void take(const Box& box) { taken_.push_back(box); }
  /// Takes the box if it is free.
  bool claim(const Box& box);

 private:
  std::vector<Box> taken_;
};

}  // namespace pal::analyzer::chart
