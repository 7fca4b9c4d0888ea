#include "pal/support/finding.hpp"

namespace pal {

std::string_view name(HintFor whom) {
  return whom == HintFor::all ? "all" : "writers";
}

std::string text_of(const PartialDiagnostic& what) {
  return filled(row(what.finding).text, placeholders(what.finding), what.arguments);
}

std::string hint_of(const PartialDiagnostic& what) {
  return filled(row(what.finding).hint, placeholders(what.finding), what.arguments);
}

std::vector<std::pair<std::string_view, std::string_view>> named_arguments(const Diagnostic& finding) {
  const Placeholders known = placeholders(finding.finding);
  std::vector<std::pair<std::string_view, std::string_view>> result;
  for (std::size_t i = 0; i < finding.arguments.size(); ++i)
    result.emplace_back(known.names[i].substr(1, known.names[i].size() - 2), finding.arguments[i]);
  return result;
}

}  // namespace pal
