// An environment with some of its worst times scaled up, as sensitivity analysis asks for.
#pragma once

#include <string>
#include <vector>

#include "analyzer/whatif/figures.hpp"

namespace pal::analyzer::whatif {

/// Of one figure, or of several in proportion. The environment must live as long.
class Scaling {
 public:
  /// `names`: of find_figure(environment, name).
  Scaling(const pan::Environment& environment, std::vector<std::string> names);

  /// The longest of the worst times, as things are.
  Nanoseconds longest() const { return longest_; }
  /// The most by which that may grow: the model allows no longer time.
  Nanoseconds most() const;

  /// `extra`: of the longest; each of the others grows by its share, rounded up. Where all are 0 they grow
  /// alike.
  pan::Environment by(Nanoseconds extra) const;

 private:
  Nanoseconds share(Nanoseconds worst, Nanoseconds extra) const;

  const pan::Environment& environment_;
  std::vector<std::string> names_;
  Nanoseconds longest_ = 0;
};

}  // namespace pal::analyzer::whatif
