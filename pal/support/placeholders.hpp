// Texts of tables with placeholders, as in {module}, whose arguments are given where the text is used. Their
// number is checked when it is compiled.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pal {

/// The first placeholder in `text`, with its braces, as in "{module}"; empty if there is none.
constexpr std::string_view first_placeholder(std::string_view text) {
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    std::size_t end = begin + 1;
    while (end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') || text[end] == '_')) ++end;
    if (text[begin] == '{' && end > begin + 1 && end < text.size() && text[end] == '}')
      return text.substr(begin, end + 1 - begin);
  }
  return {};
}

/// The placeholders of a row in the order of its arguments. Each is there once.
struct Placeholders {
  static constexpr std::size_t most = 8;

  std::array<std::string_view, most> names{};
  std::size_t count = 0;

  /// Where `name` is; `count`: nowhere.
  constexpr std::size_t index_of(std::string_view name) const {
    std::size_t i = 0;
    while (i < count && names[i] != name) ++i;
    return i;
  }
};

/// In the order in which they first stand in the texts.
constexpr Placeholders placeholders_in(std::initializer_list<std::string_view> texts) {
  Placeholders result;
  for (std::string_view rest : texts) {
    for (auto next = first_placeholder(rest); !next.empty(); next = first_placeholder(rest)) {
      if (result.index_of(next) == result.count) result.names[result.count++] = next;
      rest.remove_prefix(static_cast<std::size_t>(next.data() - rest.data()) + next.size());
    }
  }
  return result;
}

/// Is called when the arguments of a row are not as many as its placeholders: then nothing is compiled.
void wrong_number_of_arguments();

/// A row with `count` placeholders. `Row` has a function placeholders().
template <class Row, std::size_t count>
struct RowWith {
  consteval RowWith(Row of) : row(of) {  // NOLINT: a row is meant wherever this is asked for
    if (placeholders(of).count != count) wrong_number_of_arguments();
  }
  Row row;
};

inline std::string argument_text(std::string_view text) {
  return std::string(text);
}
inline std::string argument_text(std::integral auto number) {
  return std::to_string(number);
}

/// The text with the arguments in the place of the placeholders.
std::string filled(std::string_view text, const Placeholders& known,
                   const std::vector<std::string>& arguments);

}  // namespace pal
