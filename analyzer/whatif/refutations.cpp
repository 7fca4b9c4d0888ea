#include "analyzer/whatif/refutations.hpp"

#include <algorithm>
#include <utility>

namespace pal::analyzer::whatif {
namespace {

/// More would take longer to try than they spare.
constexpr std::size_t most_runs = 12;

bool contains(const RequirementIds& all, RequirementId one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

void Refutations::remember(RequirementId requirement, std::optional<Witness> witness) {
  const std::lock_guard lock(mutex_);
  std::erase(failed_, requirement);
  failed_.insert(failed_.begin(), requirement);
  if (!witness) return;
  runs_.insert(runs_.begin(),
               std::make_shared<const Refutation>(Refutation{requirement, std::move(*witness)}));
  if (runs_.size() > most_runs) runs_.pop_back();
}

std::vector<std::shared_ptr<const Refutations::Refutation>> Refutations::runs() const {
  const std::lock_guard lock(mutex_);
  return runs_;
}

RequirementIds Refutations::in_order(const RequirementIds& requirements) const {
  const std::lock_guard lock(mutex_);
  RequirementIds order;
  for (const RequirementId r : failed_) {
    if (contains(requirements, r)) order.push_back(r);
  }
  for (const RequirementId r : requirements) {
    if (!contains(order, r)) order.push_back(r);
  }
  return order;
}

}  // namespace pal::analyzer::whatif
