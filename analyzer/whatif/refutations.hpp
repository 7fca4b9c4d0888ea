// The runs that broke a requirement when it was asked with some figures.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "analyzer/verdict/verdict.hpp"
#include "analyzer/whatif/ids.hpp"

namespace pal::analyzer::whatif {

/// Shared by all threads that ask.
class Refutations {
 public:
  struct Refutation {
    RequirementId requirement;
    Witness witness;
  };

  /// `requirement` fails; `witness`: with this run, if one can be played again.
  void remember(RequirementId requirement, std::optional<Witness> witness);

  /// The last ones first.
  std::vector<std::shared_ptr<const Refutation>> runs() const;

  /// `requirements`, those that failed before the others, the last one first.
  RequirementIds in_order(const RequirementIds& requirements) const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<const Refutation>> runs_;  // the last ones first
  RequirementIds failed_;                                // the last first
};

}  // namespace pal::analyzer::whatif
