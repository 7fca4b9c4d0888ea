// What the parts of a document have in common. Private to pal/doc.
#pragma once

#include "pal/doc/document.hpp"
#include "pal/doc/words.hpp"

namespace pal::doc {

Line text(std::string words);
Line code(std::string name);
/// "a, b, c", each as code.
Line codes(const std::vector<std::string>& names);
Line operator+(Line left, const Line& right);

/// A section of these lines; without any, an empty slot.
Section paragraphs(std::string title, const std::vector<std::string>& texts);
Section items(std::string title, std::vector<Line> lines);
Section table(std::string title, Table table);

/// The name, and what its descriptions say.
Line named(const std::string& name, const std::vector<std::string>& descriptions);

/// The template of one logical sensor: its description, the drivers that it needs, methods, what it returns.
Part sensor_part(const pan::Network& network, pan::ModuleId sensor);

}  // namespace pal::doc
