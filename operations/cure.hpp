// Cures of findings: edits of the file's text after which a finding is gone. An editor offers them as a
// button.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "operations/graph.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::operations {

/// The text at `where`, with its quotation marks, becomes the name that is near; nothing if none is.
std::vector<Edit> renamed(SourceSpan where, const std::optional<std::string>& near);

/// The icon gets the field, `next`, `error` or `default`, which it does not have, and which leads to an EXIT:
/// one that there is, or a new one. `normal`: an EXIT with the code 0, or with the last one; else with
/// another code.
std::vector<Edit> led_to_exit(const Graph& graph, Place at, const char* field, bool normal);

/// A START before the first icon, which it leads to; nothing if there is no icon.
std::vector<Edit> started(const Graph& graph, std::size_t operation);

}  // namespace pal::operations
