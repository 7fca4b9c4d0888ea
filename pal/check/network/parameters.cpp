#include "pal/check/network/parameters.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "pal/check/report.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/utf8.hpp"
#include "pal/units/conversion.hpp"
#include "pal/units/unit.hpp"

namespace pal::check {

namespace {

/// Why a value in one unit is none in the other.
std::string difference(const units::Unit& left, const units::Unit& right) {
  if (left.dimension != right.dimension) return "they measure different things";
  if (left.from_zero != right.from_zero) return "their zeros differ";
  if (left.power_of_pi != right.power_of_pi)
    return "the factor between them has pi in it, so it is no fraction";
  return "the value is too great";
}

/// The first character that is no printable ASCII, for a message; nothing if there is none.
std::optional<std::string> first_not_printable(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] >= ' ' && text[at] <= '~') continue;
    const auto code = static_cast<unsigned char>(text[at]);
    if (code < 0x80) return "a control character";
    return quoted(std::string(text.substr(at, utf8::decode(text.substr(at)).bytes)));
  }
  return std::nullopt;
}

class ParameterBuilder {
 public:
  ParameterBuilder(const syntax::Parameter& written, Diagnostics& diagnostics)
      : written_(written), diagnostics_(diagnostics) {}

  pan::Parameter build() {
    pan::Parameter result;
    result.name = written_.name.text;
    result.type = written_.type;
    result.location = written_.location;
    result.unit = written_.unit;
    result.description = written_.description;
    result.where = written_.where;
    check_presence();
    if (is_text()) {
      result.default_text = default_text();
      return result;
    }
    check_range_unit();
    const auto value = in_unit(written_.default_value, {});
    const auto low = in_unit(written_.low, range_unit());
    const auto high = in_unit(written_.high, range_unit());
    result.low = is_boolean() ? 0 : low.value_or(0);
    result.high = is_boolean() ? 1 : high.value_or(result.low);
    result.default_value = value.value_or(result.low);
    if (low && high && *low > *high) {
      report(Finding::range_runs_backwards);
    } else if (low && high && value && (*value < *low || *value > *high)) {
      report(Finding::default_outside_range);
    }
    for (const auto& figure : {low, high, value}) {
      if (written_.type != pan::ScalarType::integer || !figure || std::trunc(*figure) == *figure) continue;
      report(Finding::integer_not_whole);
      break;
    }
    return result;
  }

 private:
  bool is_boolean() const { return written_.type == pan::ScalarType::boolean; }
  bool is_text() const { return written_.type == pan::ScalarType::text; }

  void report(FindingWith<1> finding) { diagnostics_.report(finding, written_.where, written_.name.text); }
  void report_range(const char* type) {
    diagnostics_.report(Finding::type_has_no_range, written_.where, written_.name.text, type);
  }

  void check_presence() {
    if (is_text()) {
      if (!written_.default_value) report(Finding::text_without_default);
      if (written_.low) report_range(written_.location ? "LOCATION" : "TEXT");
      return;
    }
    if (!written_.default_value || (!is_boolean() && !written_.low)) {
      report(either<Finding::boolean_without_default, Finding::number_without_limits>(is_boolean()));
    }
    if (is_boolean() && written_.low) report_range("BOOLEAN");
  }

  /// RANGE 10 mm/s TO 60: what 60 is in cannot be told.
  void check_range_unit() {
    if (!written_.low || !written_.high || written_.low->unit.empty() || !written_.high->unit.empty()) return;
    diagnostics_.report(Finding::unit_at_first_value_only, written_.low->where, written_.name.text);
  }

  /// RANGE 1 TO 6 cm/s: one unit behind the second stands for both.
  std::string range_unit() const { return written_.high ? written_.high->unit : std::string(); }

  /// The value in the unit of the parameter; `otherwise` is its unit if it has none of its own.
  std::optional<double> in_unit(const std::optional<syntax::Literal>& literal, const std::string& otherwise) {
    if (!literal || !check_type(*literal)) return std::nullopt;
    const auto& unit = literal->unit.empty() ? otherwise : literal->unit;
    if (unit.empty() || unit == written_.unit) return literal->value;
    const auto from = units::parse_unit(unit);
    const auto to = written_.unit.empty() ? units::Unit{} : units::parse_unit(written_.unit);
    if (!from || !to) return std::nullopt;  // reported where it stands
    const auto factor = units::factor(*from, *to);
    const auto value = factor ? units::converted(literal->digits, *factor) : std::nullopt;
    // A unit that stands for both values of a range is wrong once.
    if (!value && !literal->unit.empty()) report_unit(*literal, unit, *from, *to);
    return value;
  }

  /// Empty if what is written is no text that the parameter can hold.
  std::string default_text() {
    if (!written_.default_value) return {};
    const auto& literal = *written_.default_value;
    const auto& name = written_.name.text;
    if (!literal.text) {
      diagnostics_.report(Finding::default_must_be_text, literal.where, name);
      return {};
    }
    if (const auto foreign = first_not_printable(*literal.text)) {
      diagnostics_.report(Finding::text_not_ascii, literal.where, name, *foreign);
      return {};
    }
    if (literal.text->size() > pan::longest_text) {
      diagnostics_.report(Finding::text_too_long, literal.where, name, literal.text->size(),
                          pan::longest_text);
      return {};
    }
    return *literal.text;
  }

  bool check_type(const syntax::Literal& literal) {
    if (literal.text) {
      diagnostics_.report(either<Finding::boolean_not_text, Finding::number_not_text>(is_boolean()),
                          literal.where, written_.name.text);
      return false;
    }
    const bool truth = literal.digits.empty();
    if (truth == is_boolean()) return true;
    diagnostics_.report(either<Finding::number_not_truth, Finding::boolean_not_number>(truth), literal.where,
                        written_.name.text);
    return false;
  }

  void report_unit(const syntax::Literal& literal, const std::string& unit, const units::Unit& from,
                   const units::Unit& to) {
    if (written_.unit.empty() && from.dimension != to.dimension) {
      diagnostics_.report(Finding::parameter_without_unit, literal.where, written_.name.text, unit);
      return;
    }
    const auto own = written_.unit.empty() ? "plain numbers" : written_.unit;
    diagnostics_.report(Finding::unit_does_not_convert, literal.where, unit,
                        (written_.unit.empty() ? own : quoted(own)), written_.name.text, difference(from, to),
                        own);
  }

  const syntax::Parameter& written_;
  Diagnostics& diagnostics_;
};

}  // namespace

pan::Parameter build_parameter(const syntax::Parameter& written, Diagnostics& diagnostics) {
  return ParameterBuilder(written, diagnostics).build();
}

}  // namespace pal::check
