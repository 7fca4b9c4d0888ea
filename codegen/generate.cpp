#include "codegen/generate.hpp"

#include <iterator>

#include "codegen/emit.hpp"

namespace pal::codegen {

std::vector<GeneratedFile> emit(const Plan& plan, const EmitOptions& options) {
  std::vector<GeneratedFile> files;
  const auto add = [&](std::vector<GeneratedFile> more) {
    files.insert(files.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  files.push_back(emit_messages(plan));
  add(emit_parameters(plan));
  files.push_back(emit_activities(plan));
  files.push_back(emit_devices(plan));
  add(emit_wiring(plan));
  add(emit_modules(plan, options));
  add(emit_skill(plan));
  return files;
}

std::vector<GeneratedFile> generate(const pan::Network& network, const pan::Environment& environment,
                                    const SourceManager& sources, Diagnostics& diagnostics,
                                    const EmitOptions& options) {
  const auto plan = make_plan(network, environment, sources, diagnostics);
  if (!plan) return {};
  return emit(*plan, options);
}

}  // namespace pal::codegen
