#include "study/cells.hpp"

namespace pal::study {

std::optional<std::uint64_t> count_points(const Study& study) {
  std::uint64_t count = 1;
  for (const Figure& figure : study.figures) {
    if (__builtin_mul_overflow(count, figure.choices.size(), &count)) return std::nullopt;
  }
  return count;
}

std::vector<std::size_t> choices_at(const Study& study, std::uint64_t point) {
  std::vector<std::size_t> choices(study.figures.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    const std::uint64_t size = study.figures[i].choices.size();
    choices[i] = point % size;
    point /= size;
  }
  return choices;
}

std::vector<std::string> changes_of(const Study& study, const std::vector<std::size_t>& choices) {
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const std::vector<std::string>& own = study.figures[i].choices[choices[i]].changes;
    changes.insert(changes.end(), own.begin(), own.end());
  }
  return changes;
}

}  // namespace pal::study
