#include "operations/read_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "operations/step_log.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::operations {
namespace {

/// What keeps the step from being one of the program; empty: nothing.
std::string misfit(const Program& program, const Step& step) {
  const auto places = find_path(program, step.icon);
  if (places.empty())
    return fmt::format("operation '{}' has no icon '{}'", program.operations.front().name, step.icon);
  const Icon& icon = program.operations[places.back().operation].icons[places.back().icon];
  if (icon.skill != step.skill || subjects_text(icon) != step.sensor || icon.text != step.question)
    return fmt::format("icon '{}' of the operation does something else", step.icon);
  return {};
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
      diagnostics.report(Code::PAL1018, where, "this line is no step of an operation",
                         "give a file that 'workcell operation run --log' wrote");
      return {};
    }
    if (const std::string problem = misfit(program, *step); !problem.empty()) {
      diagnostics.report(Code::PAL1018, where, problem, "give the log of a run of this operation");
      return {};
    }
    steps.push_back(*step);
    begin = end + 1;
  }
  return steps;
}

}  // namespace pal::operations
