// The cells of a study: every combination of the values of its figures, numbered.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/study_file.hpp"

namespace pal::study {

/// The combinations, or nothing if they are more than 64 bits count. 1 if no figure is varied.
std::optional<std::uint64_t> count_points(const Study& study);

/// The choice of each figure at a combination. The last figure changes fastest.
std::vector<std::size_t> choices_at(const Study& study, std::uint64_t point);

/// The changes of all these choices, in the order of the figures.
std::vector<std::string> changes_of(const Study& study, const std::vector<std::size_t>& choices);

}  // namespace pal::study
