// Why a figure is what it is: one cause is changed at a time.
#pragma once

#include <iosfwd>

namespace pal::test {

/// Tables in Markdown: press and touch with causes switched off, and a tool that is pushed onto a plate
/// without a skill.
void write_causes(std::ostream& out);

}  // namespace pal::test
