// Compares the ports that a skill needs with those of a device.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

/// The count of numbers in a payload of these fields; `Fields` holds Field or FieldSpec.
template <class Fields>
std::size_t payload_size(const Fields& fields) {
  std::size_t size = 0;
  for (const auto& field : fields) size += slots_of(field.kind, field.count);
  return size;
}

/// True if `numbers` has the right count for the fields, and texts in the right places.
bool is_payload(std::span<const FieldSpec> fields, std::span<const double> numbers);

/// "x[255] in mm, valid[255], location as a text"; "no fields".
std::string in_words(std::span<const Field> fields);

/// How the fields of a port differ from those of a channel: "its x has 128 values, not 255". Empty: they
/// agree.
std::string difference(std::span<const Field> wanted, std::span<const FieldSpec> offered);

}  // namespace pal::runtime
