#include "pal/support/placeholders.hpp"

namespace pal {

std::string filled(std::string_view text, const Placeholders& known,
                   const std::vector<std::string>& arguments) {
  std::string result;
  for (auto next = first_placeholder(text); !next.empty(); next = first_placeholder(text)) {
    const auto before = static_cast<std::size_t>(next.data() - text.data());
    result.append(text.substr(0, before)).append(arguments[known.index_of(next)]);
    text.remove_prefix(before + next.size());
  }
  return result.append(text);
}

}  // namespace pal
