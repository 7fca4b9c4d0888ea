// How the program pal ends.
#pragma once

namespace pal::program {

enum class ExitStatus : int {
  all_hold = 0,             // done; every requirement that was checked holds
  wrong_specification = 1,  // the specification has errors
  usage = 2,                // bad command line, or a file could not be read or written
  not_met = 3,              // some requirement fails or is undecided
};

}  // namespace pal::program
