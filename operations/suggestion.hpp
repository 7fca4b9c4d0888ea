// "Did you mean …?", in bounded time however much is wrong.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pal::operations {

/// Looks for misspelt names as nearest() does, as long as it has not compared too much. After that it knows
/// no names any more: findings stay, their suggestions end.
class Suggestions {
 public:
  std::optional<std::string> nearest_to(const std::string& name, const std::vector<std::string>& candidates);

 private:
  std::size_t compared_ = 0;
};

}  // namespace pal::operations
