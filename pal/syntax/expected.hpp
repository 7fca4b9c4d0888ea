// The words that may stand at a place of a text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pal::syntax {

/// The sort of a name, number or text that may stand at a place.
enum class Wanted : std::uint8_t {
  new_name,
  message,           // of a WTM, a TXM, a slot or a requirement
  sender,            // WTM( X from …
  receiver,          // TXM( X to …
  asked,             // TXM( request X from …
  party,             // a module or device of a requirement
  condition,
  activity,          // or a module, as a statement
  activity_of_time,  // TIME …
  callee,            // Execute …
  module,            // IN …, OF …, PLACE …
  sensor_driver,
  logical_sensor,
  machine_controller,
  skill_method,
  contingency_method,
  device,            // of an environment
  processor,
  skill,
  time_unit,
  unit,
  completion_code,
  contingency_number,
  number,
  text,
  file
};

struct Expected {
  std::vector<std::string> keywords;  // in capitals, and signs; sorted
  std::vector<Wanted> wanted;         // sorted
  std::string line_begins_with;       // the first word of the line, in capitals; empty: the place is there
};

/// What may stand behind the first `offset` bytes of `text`, of which a word that is being typed is no part.
/// A mistake further up costs precision, not the answer. Never throws.
Expected expected_at(std::string_view text, std::size_t offset);

}  // namespace pal::syntax
