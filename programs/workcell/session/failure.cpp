#include "programs/workcell/session/failure.hpp"

#include <ostream>

namespace pal::workcell {

Failure::Failure(ExitStatus exit_status, std::string place, std::string cause, std::string hint)
    : std::runtime_error(place + ": " + cause),
      status_(exit_status),
      place_(std::move(place)),
      cause_(std::move(cause)),
      hint_(std::move(hint)) {}

void Failure::print(std::ostream& out) const {
  out << "workcell: error: " << place_ << ": " << cause_ << '\n';
  if (!hint_.empty()) out << "  hint: " << hint_ << '\n';
}

void check_told(std::ostream& out) {
  if (out.flush()) return;
  throw Failure(ExitStatus::usage, "standard output", "it cannot be written",
                "is it open, and is there space?");
}

}  // namespace pal::workcell
