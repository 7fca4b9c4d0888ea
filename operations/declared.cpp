#include "operations/declared.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "operations/icon_times.hpp"

namespace pal::operations {
namespace {

constexpr const char* form =
    "a line is written as: longest CODE: FORMULA, or limit FIELD, … of CHANNEL: KIND VALUE";
constexpr const char* value_form =
    "a limit is PARAMETER, NUMBER * PARAMETER, either of them after - or +-, or one of these +- another";
constexpr std::array limit_kinds{"band", "target", "stop", "error"};

struct Wrong {
  std::string cause;
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Names, numbers and signs of one line.
class Line {
 public:
  explicit Line(std::string_view text) : text_(text.substr(0, text.find('#'))) {
    while (!text_.empty() && (text_.back() == ' ' || text_.back() == '\t' || text_.back() == '\r'))
      text_.remove_suffix(1);
  }

  bool at_end() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ == text_.size();
  }
  bool takes(std::string_view sign) {
    if (at_end() || !text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }
  /// Empty: there is none.
  std::string name() {
    if (at_end() || !is_letter(text_[at_])) return {};
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '-')) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }
  template <typename Number>
  std::optional<Number> number() {
    if (at_end() || !is_digit(text_[at_])) return std::nullopt;
    Number value{};
    const auto [end, problem] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (problem != std::errc()) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }
  std::string rest() {
    at_end();
    return std::string(text_.substr(at_));
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

Share share(Line& line) {
  Share result;
  const double sign = line.takes("-") ? -1 : 1;
  const auto factor = line.number<double>();
  if (factor && !line.takes("*")) throw Wrong{value_form};
  result.factor = sign * factor.value_or(1);
  result.parameter = line.name();
  if (result.parameter.empty()) throw Wrong{value_form};
  return result;
}

DeclaredLimit read_limit(Line& line) {
  DeclaredLimit limit;
  do {
    limit.fields.push_back(line.name());
    if (limit.fields.back().empty()) throw Wrong{form};
  } while (line.takes(","));
  if (line.name() != "of") throw Wrong{form};
  limit.channel = line.name();
  if (limit.channel.empty() || !line.takes(":")) throw Wrong{form};
  const std::string kind = line.name();
  const auto found = std::find(limit_kinds.begin(), limit_kinds.end(), kind);
  if (found == limit_kinds.end())
    throw Wrong{kind.empty() ? form
                             : fmt::format("there is no limit '{}'; there are {}", kind,
                                           fmt::join(limit_kinds, ", "))};
  limit.kind = static_cast<DeclaredLimit::Kind>(found - limit_kinds.begin());
  limit.both = line.takes("+-");
  limit.at = share(line);
  if (!limit.both && line.takes("+-")) {
    limit.both = true;
    limit.around = limit.at;
    limit.at = share(line);
  }
  if (!line.at_end()) throw Wrong{fmt::format("'{}' is more than a limit has; {}", line.rest(), value_form)};
  return limit;
}

void read_time(Line& line, int number, Declared& to) {
  const auto code = line.number<int>();
  if (!code || !line.takes(":")) throw Wrong{form};
  const std::string text = line.rest();
  auto formula = Formula::parse(text);
  if (!formula)
    throw Wrong{
        fmt::format("'{}' is no formula: it has numbers, parameters, + - * / ( ), abs, max and norm, "
                    "and blanks around + and -",
                    text)};
  if (!to.longest.emplace(*code, DeclaredTime{number, std::move(*formula)}).second)
    throw Wrong{fmt::format("the longest time to completion {} is declared twice", *code)};
}

void read_line(std::string_view text, int number, Declared& to) {
  Line line(text);
  if (line.at_end()) return;
  const std::string what = line.name();
  if (what == "longest") return read_time(line, number, to);
  if (what != "limit") throw Wrong{form};
  to.limits.push_back(read_limit(line));
  to.limits.back().line = number;
}

/// Empty: a number is there.
std::string why_no_number(const std::string& name, const pan::Template& skill) {
  for (const pan::Parameter& each : skill.parameters) {
    if (each.name != name) continue;
    return each.type == pan::ScalarType::text ? fmt::format("the parameter '{}' is no number", name) : "";
  }
  return fmt::format("{} has no parameter '{}'", skill.name, name);
}

}  // namespace

std::variant<Declared, DeclaredError> read_declared(std::string_view text) {
  Declared result;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    try {
      read_line(text.substr(0, end), number, result);
    } catch (const Wrong& wrong) {
      return DeclaredError{number, wrong.cause};
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::optional<DeclaredError> misfit(const Declared& declared, const pan::Template& skill) {
  for (const auto& [code, time] : declared.longest) {
    if (std::none_of(skill.completions.begin(), skill.completions.end(),
                     [&](const pan::Completion& each) { return each.code == code; }))
      return DeclaredError{time.line, fmt::format("{} has no completion {}", skill.name, code)};
    std::string why;
    time.seconds.over([&](const std::string& name) -> std::optional<ValueRange> {
      const std::string problem = why_no_number(name, skill);
      if (why.empty()) why = problem;
      return problem.empty() ? std::optional(ValueRange{1, 1}) : std::nullopt;
    });
    if (!why.empty()) return DeclaredError{time.line, why};
    if (!declared_longest(skill, code, {}, nullptr, {{{skill.name, code}, time.seconds}}))
      return DeclaredError{time.line, "it is no time when all parameters have their defaults"};
  }
  for (const DeclaredLimit& limit : declared.limits) {
    std::string why = why_no_number(limit.at.parameter, skill);
    if (why.empty() && limit.around) why = why_no_number(limit.around->parameter, skill);
    if (!why.empty()) return DeclaredError{limit.line, why};
  }
  return std::nullopt;
}

}  // namespace pal::operations
