// The samples of a run, on the disk as they come, or in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pal/trace/spool.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// Gives all samples of a run to a function, in order; as often as it is called.
using SampleSource = std::function<void(const std::function<void(const Sample&)>&)>;

/// The samples of a list, which outlives the source.
SampleSource samples_of(const std::vector<Sample>& log);

class SampleSpool {
 public:
  explicit SampleSpool(trace::SpoolPlace place = trace::SpoolPlace::disk) : rows_(place) {}
  void append(const Sample& sample) noexcept;
  std::size_t size() const { return rows_.size(); }
  bool failed() const { return rows_.failed(); }
  void for_each(const std::function<void(const Sample&)>& see) const;
  /// All of them, if they are not more than `most`. Otherwise those that keep every peak and every dip of the
  /// contact force, of the grip and of the distance between tool and set-point: fewer than `most`.
  std::vector<Sample> telling(std::size_t most) const;

 private:
  struct Row {
    std::int64_t time_ns;
    double figures[35];  // as row_of() puts them
  };
  static Row row_of(const Sample& sample);
  static Sample sample_of(const Row& row);

  trace::Spool<Row> rows_;
};

}  // namespace pal::sim
