// What values of icons may be: of parameters, arguments and numbers that are known only when it runs.
#pragma once

#include <string>

#include "operations/graph.hpp"
#include "operations/suggestion.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::operations {

/// The argument of the operation; null if it has none of this name.
const pan::Parameter* find_argument(const Operation& operation, const std::string& name);

/// "a number from 1 to 40 N", "a text in double quotes", …
std::string type_text(const pan::Parameter& parameter);

/// Reports `given`, a parameter of an icon of `operation`, if `wanted` cannot have its value (PAL1009). An
/// argument must have the type, the unit and no values beyond the range of `wanted`; how far a count or an
/// output goes is known when it runs. `owner`: whose parameter it is. The answer: whether it fits.
bool check_fit(const pan::Parameter& wanted, const Parameter& given, const Operation& operation,
               const std::string& owner, Diagnostics& diagnostics);

/// Checks where the values of an icon come from: that what is counted, or reports a figure, is there and can
/// (PAL1004), that the operation has the argument (PAL1019), and that arguments have the type, unit and range
/// of what they stand for (PAL1009). Of a hierarchical icon, also that its parameters are arguments of what
/// it stands for (PAL1008). Needs no skills.
void check_values(const Graph& graph, Place at, const Icon& icon, Suggestions& suggestions,
                  Diagnostics& diagnostics);

}  // namespace pal::operations
