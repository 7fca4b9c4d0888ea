// The files of the folder viewer, as they are: the page with places to fill (@TITLE@, …), its style and its
// script. The build makes viewer.cpp of them.
#pragma once

#include <string_view>

namespace pal::analyzer::chart::viewer {

extern const std::string_view page;
extern const std::string_view style;
extern const std::string_view script;

}  // namespace pal::analyzer::chart::viewer
