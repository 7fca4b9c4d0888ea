// C++ from a skill and an environment.
#pragma once

#include <string>
#include <vector>

#include "codegen/plan.hpp"

namespace pal::codegen {

/// A generated file; `name` has no folder.
struct GeneratedFile {
  std::string name;
  std::string text;
};

struct EmitOptions {
  /// Debuggers show the lines of PAL for the code of a body (#line).
  bool debug_lines = false;
};

/// The C++ of a plan, in a fixed order; the same plan gives the same bytes. docs/reference/runtime.md shows
/// what it looks like.
std::vector<GeneratedFile> emit(const Plan& plan, const EmitOptions& options = {});

/// The file that makes a plug-in of the skill: <skill>_plugin.cpp. It holds every text of `sources`, of which
/// `declared` is what the skill declares; invalid: nothing.
GeneratedFile emit_plugin(const Plan& plan, const SourceManager& sources, FileId declared = {});

/// A file to begin with, which is never written again: every activity, empty, and the function that
/// emit_plugin asks for. <skill>.cpp.
GeneratedFile emit_empty_activities(const Plan& plan);

/// make_plan and emit. Nothing if the environment lacks something (reported).
std::vector<GeneratedFile> generate(const pan::Network& network, const pan::Environment& environment,
                                    const SourceManager& sources, Diagnostics& diagnostics,
                                    const EmitOptions& options = {});

}  // namespace pal::codegen
