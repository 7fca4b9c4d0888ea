#include "operations/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::operations {

Fields::Fields(const JsonValue& object, Diagnostics& diagnostics)
    : object_(object), diagnostics_(diagnostics), taken_(object.members.size(), false) {}

const JsonValue* Fields::find(const std::string& name) {
  known_.push_back(name);
  const JsonValue* found = nullptr;
  for (std::size_t i = 0; i < object_.members.size(); ++i) {
    if (object_.members[i].name != name) continue;
    taken_[i] = true;
    if (found != nullptr) report(Finding::field_given_twice, object_.members[i].where, name);
    found = &object_.members[i].value;
  }
  return found;
}

const JsonValue* Fields::find(const std::string& name, Kind kind, const char* what) {
  const JsonValue* value = find(name);
  if (value == nullptr || value->kind == kind) return value;
  refuse(name);
  report(Finding::field_of_another_type, value->where, name, what);
  return nullptr;
}

std::string Fields::text(const std::string& name, SourceSpan* where) {
  const JsonValue* value = find(name, JsonValue::Kind::text, "a text in double quotes");
  if (value == nullptr) return {};
  if (where != nullptr) *where = value->where;
  return value->text;
}

std::string Fields::needed_text(const std::string& name, SourceSpan* where) {
  const std::string result = text(name, where);
  if (result.empty()) missing(name);
  return result;
}

Connection Fields::connection(const std::string& name) {
  Connection result;
  result.icon = text(name, &result.where);
  return result;
}

bool Fields::refused(const std::string& name) const {
  return std::find(refused_.begin(), refused_.end(), name) != refused_.end();
}

void Fields::missing(const std::string& name) {
  if (refused(name)) return;
  report(Finding::field_missing, object_.where, name);
}

void Fields::refuse_the_rest() {
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i]) continue;
    const JsonMember& member = object_.members[i];
    report(Finding::unknown_field, member.where, member.name, fmt::format("{}", fmt::join(known_, ", ")))
        .suggest(nearest(member.name, known_));
  }
}

bool is_code(const JsonValue& value) {
  return value.kind == JsonValue::Kind::number && value.whole && std::abs(value.number) <= 1e6;
}

Source read_source(const JsonValue& object, Diagnostics& diagnostics) {
  Fields fields(object, diagnostics);
  Source source;
  SourceSpan where;
  const std::string counted = fields.text("count-of"), argument = fields.text("argument");
  const std::string reporter = fields.text("output-of"), output = fields.text("name");
  const int given = (counted.empty() ? 0 : 1) + (argument.empty() ? 0 : 1) + (reporter.empty() ? 0 : 1);
  if (given != 1 || output.empty() == !reporter.empty() || object.members.size() > 2) {
    fields.report(Finding::no_source, object.where);
    return source;
  }
  if (!counted.empty()) source = {Source::Kind::count, counted, {}};
  if (!argument.empty()) source = {Source::Kind::argument, {}, argument};
  if (!reporter.empty()) source = {Source::Kind::output, reporter, output};
  fields.refuse_the_rest();
  return source;
}

std::optional<Amount> amount_of(const JsonValue& value, const std::string& name, const Range& range,
                                Fields& fields, Diagnostics& diagnostics) {
  Amount amount{value.number, value.where, {}};
  if (value.kind == JsonValue::Kind::object) {
    amount.source = read_source(value, diagnostics);
    if (!amount.source.written()) return amount;
  } else if (value.kind != JsonValue::Kind::number) {
    fields.report(Finding::field_not_a_number, value.where, name);
  } else if (!(value.number >= range.low && value.number <= range.high) ||
             (range.whole && std::floor(value.number) != value.number)) {
    fields.report(Finding::number_not_in_range, value.where, name, range.what, fmt::to_string(range.low),
                  fmt::to_string(range.high), range.unit, range.whole ? "a whole number" : "a number");
  } else {
    return amount;
  }
  fields.refuse(name);
  return std::nullopt;
}

std::optional<Amount> read_amount(const std::string& name, const Range& range, Fields& fields,
                                  Diagnostics& diagnostics) {
  const JsonValue* value = fields.find(name);
  if (value == nullptr) return std::nullopt;
  return amount_of(*value, name, range, fields, diagnostics);
}

std::optional<double> read_number(const std::string& name, const Range& range, Fields& fields,
                                  Diagnostics& diagnostics) {
  const JsonValue* value = fields.find(name, JsonValue::Kind::number, "a number");
  if (value == nullptr) return std::nullopt;
  const auto amount = amount_of(*value, name, range, fields, diagnostics);
  if (!amount) return std::nullopt;
  return amount->number;
}

}  // namespace pal::operations
