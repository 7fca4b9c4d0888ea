#include "pal/check/conditions/guards.hpp"

namespace pal::check::conditions {

void conditions_of(const pan::Guard& guard, std::vector<pan::ConditionId>& result) {
  if (guard.kind == pan::Guard::Kind::equals &&
      std::find(result.begin(), result.end(), guard.condition) == result.end())
    result.push_back(guard.condition);
  for (const auto& term : guard.terms) conditions_of(term, result);
}

}  // namespace pal::check::conditions
