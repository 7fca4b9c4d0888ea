#include "pal/explain/codes.hpp"

#include <algorithm>
#include <cctype>

#include "pal/support/nearest.hpp"

namespace pal::explain {
namespace {

std::string in_lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The number in "PAL0123" or "123"; at most four digits, as codes have.
std::optional<int> number_in(std::string_view text) {
  const auto lower = in_lower_case(text);
  const auto digits = lower.starts_with("pal") ? lower.substr(3) : lower;
  const bool all = std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c); });
  if (digits.empty() || digits.size() > 4 || !all) return std::nullopt;
  return std::stoi(digits);
}

int number_of(Code code) {
  return *number_in(name(code));
}

}  // namespace

std::vector<Code> all_codes() {
  std::vector<Code> codes;
  for (std::size_t i = 0; i < code_count(); ++i) codes.push_back(static_cast<Code>(i));
  return codes;
}

std::optional<Code> find_code(std::string_view text) {
  const auto number = number_in(text);
  if (!number) return std::nullopt;
  for (const Code code : all_codes()) {
    if (number_of(code) == *number) return code;
  }
  return std::nullopt;
}

std::vector<Code> codes_near(std::string_view text) {
  auto codes = all_codes();
  if (const auto number = number_in(text)) {
    const auto distance = [&](Code code) { return std::abs(number_of(code) - *number); };
    std::stable_sort(codes.begin(), codes.end(), [&](Code a, Code b) { return distance(a) < distance(b); });
    return {std::min(codes.at(0), codes.at(1)), std::max(codes.at(0), codes.at(1))};
  }
  const auto wanted = in_lower_case(text);
  std::vector<Code> found;
  std::vector<std::string> names;
  for (const Code code : codes) {
    if (!wanted.empty() && in_lower_case(title(code)).find(wanted) != std::string::npos)
      found.push_back(code);
    names.emplace_back(name(code));
  }
  if (!found.empty()) return found;
  const auto close = nearest(text, names);
  if (close) found.push_back(*find_code(*close));
  return found;
}

}  // namespace pal::explain
