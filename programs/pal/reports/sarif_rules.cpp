// The rules of a SARIF log: a row for each code of a finding.
#include <cctype>
#include <nlohmann/json.hpp>

#include "pal/explain/page.hpp"
#include "programs/pal/reports/json_text.hpp"
#include "programs/pal/reports/sarif.hpp"

namespace pal::program {
namespace {

using Json = nlohmann::ordered_json;

/// "syntax error" as an identifier (3.49.7): "SyntaxError".
std::string identifier(std::string_view words) {
  std::string result;
  bool begins = true;
  for (const char c : words) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter)) result += begins ? static_cast<char>(std::toupper(letter)) : c;
    begins = !std::isalnum(letter);
  }
  return result;
}

Json rule(Code code) {
  const explain::Page page = explain::explain(code);
  Json rule;
  rule["id"] = name(code);
  rule["name"] = identifier(title(code));
  rule["shortDescription"]["text"] = title(code);
  rule["fullDescription"]["text"] = page.summary;
  std::string anchor(name(code));
  for (char& c : anchor) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  rule["helpUri"] = PAL_DOCUMENTATION_URL "/reference/diagnostics.md#" + anchor;
  rule["help"]["text"] = "pal explain " + std::string(name(code));
  rule["help"]["markdown"] = page.markdown;
  rule["defaultConfiguration"]["level"] = name(severity(code));
  return rule;
}

}  // namespace

std::string sarif_rules(const std::vector<Code>& codes) {
  auto rules = Json::array();
  for (const Code code : codes) rules.push_back(rule(code));
  return json_text(rules);
}

}  // namespace pal::program
