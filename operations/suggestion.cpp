#include "operations/suggestion.hpp"

#include "pal/support/nearest.hpp"

namespace pal::operations {
namespace {

constexpr std::size_t most_compared = 200'000;  // names
constexpr std::size_t longest_name = 64;        // a longer one has no misspelling that a person would make

}  // namespace

std::optional<std::string> Suggestions::nearest_to(const std::string& name,
                                                   const std::vector<std::string>& candidates) {
  if (name.size() > longest_name || compared_ + candidates.size() > most_compared) return std::nullopt;
  compared_ += candidates.size();
  return nearest(name, candidates);
}

}  // namespace pal::operations
