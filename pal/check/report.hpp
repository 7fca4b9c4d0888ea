// Findings that several families of checks make.
#pragma once

#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/statement.hpp"

namespace pal::frontend {

/// `second` is declared where `first` already is.
void report_twice(Diagnostics& diagnostics, const std::string& what, const syntax::Name& second,
                  const syntax::Name& first);

/// There is no `what` of that name; says which of `known` may be meant, else `otherwise`.
void report_unknown(Diagnostics& diagnostics, Code code, const std::string& what, const syntax::Name& name,
                    const std::vector<std::string>& known, const std::string& otherwise);

/// "'name'".
std::string quoted(const std::string& name);

}  // namespace pal::frontend
