// One emitter for each concept; each gives the text of its own files.
#pragma once

#include "codegen/generate.hpp"
#include "codegen/writer.hpp"

namespace pal::codegen {

/// Messages with fields, as structs.
GeneratedFile emit_messages(const Plan& plan);
/// The parameter vector, with ranges and setting by name.
std::vector<GeneratedFile> emit_parameters(const Plan& plan);
/// What the author of a device derives from.
GeneratedFile emit_devices(const Plan& plan);
/// What the system programmer implements.
GeneratedFile emit_activities(const Plan& plan);
/// The modules as coroutines.
std::vector<GeneratedFile> emit_modules(const Plan& plan, const EmitOptions& options);
/// Threads, statements, channels, conditions, places and times as tables.
std::vector<GeneratedFile> emit_wiring(const Plan& plan);
/// The skill that the dispatcher runs, its description and its factory.
std::vector<GeneratedFile> emit_skill(const Plan& plan);

/// For emit_wiring: the requirements and promises that a run is compared with.
void write_promises(Writer& out, const Plan& plan);

/// The store in which the module keeps its messages; null: it keeps them in members of its own.
const PlannedStore* store_of(const Plan& plan, const PlannedModule& module);

/// The body of a module or of a block as C++ statements.
void write_body(Writer& out, const Plan& plan, const PlannedModule& module, const PlannedBody& body,
                const EmitOptions& options);

}  // namespace pal::codegen
