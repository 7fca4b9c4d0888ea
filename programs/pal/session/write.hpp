// How commands write their files.
#pragma once

#include <string>
#include <vector>

#include "pal/support/output.hpp"
#include "programs/pal/session/console.hpp"
#include "programs/pal/session/exit_status.hpp"
#include "programs/pal/session/selection.hpp"

namespace pal::program {

/// The texts that a command has read, by the paths under which it read them.
std::vector<std::string> inputs_of(const Session& session);

/// Whether a command that has read `inputs` may write `outputs`. None of these may be an input, under
/// whatever name, and none may be named like a PAL file. Says on `console.err` which is wrong. Empty paths
/// are ignored.
bool may_write(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs,
               const Console& console);

/// Writes all files or none, and lists on `console.out` those that stay; or says what was wrong on
/// `console.err`. `inputs`: see may_write.
ExitStatus write_and_list(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs,
                          const Console& console);

}  // namespace pal::program
