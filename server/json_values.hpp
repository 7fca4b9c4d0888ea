// How the JSON protocol tells the state, skills and sensors (docs/reference/protocols.md). The
// schema is server/schema/protocol.json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/command.hpp"
#include "server/desk.hpp"
#include "server/event.hpp"
#include "server/knowledge.hpp"
#include "server/store.hpp"

namespace pal::server {

using Json = nlohmann::ordered_json;

double seconds(Duration time);
/// "2026-11-28T10:59:24.123Z".
std::string wall_text(WallTime time);

/// In one line. Bytes that are not UTF-8 are replaced.
std::string dump(const Json& json);

Json describe(const operations::Value& value);
Json value_or_null(const std::optional<operations::Value>& value);
Json describe(const std::vector<operations::Parameter>& parameters);
Json describe(const std::optional<Hold>& hold);
Json describe(const OpenQuestion& question);
Json describe(const ControlsAsked& asking);
Json describe(const operations::Source& source);
/// Of a step that goes on nothing is told that is not known yet.
Json describe_step(const operations::Step& step, bool ended);
Json describe(const Status& status);
Json describe(const Snapshot& snapshot);
Json describe(const std::vector<Present>& clients);
Json describe(const operations::Breakpoint& breakpoint);
Json describe(const std::vector<operations::Breakpoint>& breakpoints);
Json describe(const Outlook& outlook);
Json describe(const IconValues& values);
/// `cell`: which of the skills it cannot run, and what it declares of their times.
Json describe(const operations::Skills& skills, const Facts& facts, const operations::Cell& cell);
Json describe(const KnownRequirement& requirement);
Json describe(const operations::Sensors& sensors, const std::map<std::string, LastReading>& readings);
Json describe(const StoredEntry& entry);
Json describe(const Location& location);
/// Of a `skill` its result and times; of another command nothing: an empty object.
Json describe(const Done& done, bool skill);

}  // namespace pal::server
