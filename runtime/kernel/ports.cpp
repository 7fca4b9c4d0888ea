#include "runtime/kernel/ports.hpp"

#include <algorithm>
#include <string_view>

namespace pal::runtime {

namespace {

std::string fields_in_words(std::size_t count) {
  return count == 0 ? "no fields" : count == 1 ? "1 field" : std::to_string(count) + " fields";
}

std::string values_in_words(std::size_t count) {
  return count == 1 ? "1 value" : std::to_string(count) + " values";
}

std::string unit_in_words(std::string_view unit) {
  return unit.empty() ? "a plain number" : "in " + std::string(unit);
}

const char* kind_in_words(FieldKind kind) {
  return kind == FieldKind::text ? "a text" : "a number";
}

}  // namespace

bool is_payload(std::span<const FieldSpec> fields, std::span<const double> numbers) {
  if (numbers.size() != payload_size(fields)) return false;
  for (const FieldSpec& field : fields) {
    const std::size_t slots = slots_of(field.kind, field.count);
    for (std::size_t at = 0; field.kind == FieldKind::text && at < slots; at += Text::slots) {
      if (!Text::unpack(numbers.subspan(at).first<Text::slots>())) return false;
    }
    numbers = numbers.subspan(slots);
  }
  return true;
}

std::string in_words(std::span<const Field> fields) {
  if (fields.empty()) return "no fields";
  std::string text;
  for (const Field& field : fields) {
    text += (text.empty() ? "" : ", ") + std::string(field.name);
    if (field.count != 1) text += '[' + std::to_string(field.count) + ']';
    if (!field.unit.empty()) text += " in " + std::string(field.unit);
    if (field.kind == FieldKind::text) text += " as a text";
  }
  return text;
}

std::string difference(std::span<const Field> wanted, std::span<const FieldSpec> offered) {
  for (std::size_t i = 0; i < std::min(wanted.size(), offered.size()); ++i) {
    const Field& a = wanted[i];
    const FieldSpec& b = offered[i];
    const std::string name(a.name);
    if (a.name != b.name) return "its field " + std::to_string(i + 1) + " is " + b.name + ", not " + name;
    if (a.kind != b.kind)
      return "its " + name + " is " + kind_in_words(b.kind) + ", not " + kind_in_words(a.kind);
    if (a.count != b.count)
      return "its " + name + " has " + values_in_words(b.count) + ", not " + std::to_string(a.count);
    if (a.unit != b.unit)
      return "its " + name + " is " + unit_in_words(b.unit) + ", not " + unit_in_words(a.unit);
  }
  if (wanted.size() == offered.size()) return {};
  return "its message has " + fields_in_words(offered.size()) + ", not " + std::to_string(wanted.size());
}

}  // namespace pal::runtime
