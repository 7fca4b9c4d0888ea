// How commands leave their files.
#pragma once

#include <string>
#include <vector>

#include "pal/driver/console.hpp"
#include "pal/driver/exit_status.hpp"
#include "pal/driver/selection.hpp"
#include "pal/support/output.hpp"

namespace pal::driver {

/// The texts that a command has read, by the paths under which it has.
std::vector<std::string> inputs_of(const Session& session);

/// Whether `outputs` may be written by a command that has read `inputs`: none of them is one of these, under
/// whatever name, and none is called as a PAL file is. Says on `console.err` which is. Empty paths are none.
bool may_write(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs,
               const Console& console);

/// Writes all files or none, and lists those that stay on `console.out`; or says what was wrong on
/// `console.err`. `inputs`: see may_write.
ExitStatus write_and_list(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs,
                          const Console& console);

}  // namespace pal::driver
