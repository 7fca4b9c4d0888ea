// Codes of the findings, from the one table in diagnostic_code.def.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pal {

enum class Severity;

enum class Code : std::uint16_t {
#define PAL_DIAGNOSTIC(code, severity, title) code,
#include "pal/support/diagnostic_code.def"
};

/// The subject of findings, each a hundred of codes.
enum class Family {
#define PAL_FAMILY(family) family,
#include "pal/support/diagnostic_code.def"
};

/// "PAL0101".
std::string_view name(Code code);
/// The severity that the table gives.
Severity severity(Code code);
/// The family in the table.
Family family(Code code);
/// The table's short title, lower case.
std::string_view title(Code code);
/// How many rows the table has; a code is its row's number.
std::size_t code_count();

/// "note", "warning", "error".
std::string_view name(Severity severity);

}  // namespace pal
