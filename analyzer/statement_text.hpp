// Statements as PAL writes them.
#pragma once

#include <string>

#include "pal/pan/network.hpp"

namespace pal::analyzer {

/// The canonical spelling of a statement: "TXM( motion to MC1 )", "WTM( motion request from MC1 )",
/// "UNTIL( pc-force OR pc-reach )", the bare name of an activity. Of a CASE: "CASE".
std::string statement_text(const pan::Network& network, const pan::Node& node);

/// Name of a module or device.
std::string party_name(const pan::Network& network, const pan::Party& party);

}  // namespace pal::analyzer
