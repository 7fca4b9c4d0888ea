#include "operations/read_log.hpp"

#include <algorithm>
#include <optional>

#include "operations/step_log.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

/// What keeps the step from being one of the program, if something does.
std::optional<PartialDiagnostic> misfit(const Program& program, const Step& step) {
  const auto places = find_path(program, step.icon);
  if (places.empty())
    return PartialDiagnostic(Finding::log_of_no_icon, program.operations.front().name, step.icon);
  const Icon& icon = program.operations[places.back().operation].icons[places.back().icon];
  if (icon.skill != step.skill || subjects_text(icon) != step.sensor || icon.text != step.question)
    return PartialDiagnostic(Finding::icon_does_something_else, step.icon);
  return std::nullopt;
}

}  // namespace

std::vector<Step> read_log(const SourceManager& sources, FileId file, const Program& program,
                           Diagnostics& diagnostics) {
  const std::string_view text = sources.text(file);
  std::vector<Step> steps;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const auto step = parse_log_line(std::string(text.substr(begin, end - begin)));
    const SourceSpan where{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin)};
    if (!step) {
      diagnostics.report(Finding::no_step_of_operation, where);
      return {};
    }
    if (const auto problem = misfit(program, *step)) {
      diagnostics.report(*problem, where);
      return {};
    }
    steps.push_back(*step);
    begin = end + 1;
  }
  return steps;
}

}  // namespace pal::operations
