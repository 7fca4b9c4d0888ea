// Findings that several families of checks make.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/statement.hpp"

namespace pal::checker {

/// `second` is declared where `first` already is.
void report_twice(Diagnostics& diagnostics, const std::string& what, const syntax::Name& second,
                  const syntax::Name& first);

/// Whether to look which of so many known names an unknown one may be meant to be: not where hundreds are
/// unknown, of which none is a slip of the fingers, and comparing all with all takes long.
bool may_guess(const Diagnostics& diagnostics, std::size_t known);

/// There is no `what` of that name; says which of `known` may be meant, and where that is `declared`, else
/// `otherwise`.
using DeclaredAt = std::function<std::optional<SourceSpan>(const std::string& name)>;
void report_unknown(Diagnostics& diagnostics, Code code, const std::string& what, const syntax::Name& name,
                    const std::vector<std::string>& known, const std::string& otherwise,
                    const DeclaredAt& declared = {});

/// "'name'".
std::string quoted(const std::string& name);

}  // namespace pal::checker
