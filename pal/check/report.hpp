// Findings that several families of checks make.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/finding.hpp"
#include "pal/syntax/statement.hpp"

namespace pal::check {

/// `second` is declared where `first` already is.
void report_twice(Diagnostics& diagnostics, const std::string& what, const syntax::Name& second,
                  const syntax::Name& first);

/// Whether to look for a similar name among `known` names. Not if hundreds are unknown: then none is a
/// misspelling, and comparing all with all takes long.
bool may_guess(const Diagnostics& diagnostics, std::size_t known);

/// Reports `what`, about a `name` that is not known. Suggests the nearest of `known` with the place where it
/// is `declared`, if there is one.
using DeclaredAt = std::function<std::optional<SourceSpan>(const std::string& name)>;
void report_unknown(Diagnostics& diagnostics, const PartialDiagnostic& what, const syntax::Name& name,
                    const std::vector<std::string>& known, const DeclaredAt& declared = {});

/// "'name'".
std::string quoted(const std::string& name);

}  // namespace pal::check
