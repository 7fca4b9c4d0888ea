#include "programs/workcell/commands/refused_operation.hpp"

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/render.hpp"

namespace pal::workcell {

Failure refused_operation(const std::string& file, const Diagnostics& diagnostics,
                          const SourceManager& sources, std::ostream& error) {
  const auto& all = diagnostics.all();
  const bool unreadable = !all.empty() && all.front().code == Code::PAL0111 && all.front().where.end == 0;
  if (unreadable) {
    const Diagnostic& finding = diagnostics.all().front();
    return {ExitStatus::usage, "operation", finding.message, finding.hint};
  }
  render_text(diagnostics.sorted(), sources, error);
  return {ExitStatus::wrong_specification, file, "the operation has errors, so nothing moved",
          "pal operation check shows them all"};
}

}  // namespace pal::workcell
