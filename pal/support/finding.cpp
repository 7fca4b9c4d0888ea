#include "pal/support/finding.hpp"

namespace pal {
namespace {

std::string filled(std::string_view text, const PartialDiagnostic& what) {
  const Placeholders known = placeholders(row(what.finding));
  std::string result;
  for (auto next = first_placeholder(text); !next.empty(); next = first_placeholder(text)) {
    const auto before = static_cast<std::size_t>(next.data() - text.data());
    result.append(text.substr(0, before)).append(what.arguments[known.index_of(next)]);
    text.remove_prefix(before + next.size());
  }
  return result.append(text);
}

}  // namespace

std::string text_of(const PartialDiagnostic& what) {
  return filled(row(what.finding).text, what);
}

std::string hint_of(const PartialDiagnostic& what) {
  return filled(row(what.finding).hint, what);
}

}  // namespace pal
