// The beginnings of the PAL file of a skill that an operation only plans.
#pragma once

#include <string>

#include "operations/model.hpp"

namespace pal::operations {

/// A skill with the parameters and codes of the planned icon, whose method does nothing yet. It passes
/// `pal check --without-times`. A sign that PAL cannot have in a name or a text is replaced.
std::string skeleton_of(const Icon& planned);

/// The name that the skill has there: of lower case letters, digits and hyphens.
std::string skeleton_name(const Icon& planned);

}  // namespace pal::operations
