// Text inside XML: SVG, HTML, the labels of Graphviz.
#pragma once

#include <string>
#include <string_view>

namespace pal {

/// For the text of an element or an attribute in double quotes. What XML cannot hold at all, control
/// characters, becomes U+FFFD.
std::string xml_escaped(std::string_view text);

}  // namespace pal
