#include "programs/workcell/commands/refused_operation.hpp"

#include "pal/support/render.hpp"

namespace pal::workcell {

Failure refused_operation(const std::string& file, const Diagnostics& diagnostics,
                          const SourceManager& sources, std::ostream& error) {
  const bool unreadable = sources.size() == 1 && !sources.was_read(FileId(0)) && !diagnostics.all().empty();
  if (unreadable) {
    const Diagnostic& finding = diagnostics.all().front();
    return {ExitStatus::usage, "operation", finding.message, finding.hint};
  }
  render_text(diagnostics.sorted(), sources, error);
  return {ExitStatus::wrong_specification, file, "the operation has errors, so nothing moved",
          "pal operation check shows them all"};
}

}  // namespace pal::workcell
