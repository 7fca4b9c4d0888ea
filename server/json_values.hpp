// What the JSON protocol says of events, the state, skills and sensors (docs/reference/protocols.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "server/command.hpp"
#include "server/desk.hpp"
#include "server/event.hpp"

namespace pal::server {

using Json = nlohmann::ordered_json;

double seconds(Duration time);

/// In one line. Bytes that are not UTF-8 are replaced.
std::string dump(const Json& json);

Json describe(const Event& event);
Json describe(const Status& status);
Json describe(const operations::Skills& skills);
Json describe(const operations::Sensors& sensors);
/// Of a `skill` its result and times; of another command nothing: an empty object.
Json describe(const Done& done, bool skill);

}  // namespace pal::server
