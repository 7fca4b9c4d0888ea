// What generated text calls the PAL files.
#pragma once

#include <string>

#include "pal/support/source.hpp"

namespace pal::codegen {

/// The name of `file` as seen from the folder of `skill`, the file with the SKILL: "touch.pal",
/// "../modules/alter.pal". The same wherever pal is started, and however its arguments name the files.
std::string file_name(const SourceManager& sources, FileId file, FileId skill);

}  // namespace pal::codegen
