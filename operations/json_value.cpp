#include "operations/json_value.hpp"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "pal/support/finding.hpp"
#include "pal/support/merge_conflict.hpp"

namespace pal::operations {
namespace {

constexpr std::size_t deepest = 32;

/// Walks the text and tells how far the reader has come.
class Counting {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Counting() = default;
  Counting(const char* begin, const char* at, std::size_t* count) : begin_(begin), at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  Counting& operator++() {
    ++at_;
    if (count_ != nullptr) *count_ = static_cast<std::size_t>(at_ - begin_);
    return *this;
  }
  Counting operator++(int) {
    Counting before = *this;
    ++*this;
    return before;
  }
  [[maybe_unused]] friend bool operator==(const Counting& a, const Counting& b) { return a.at_ == b.at_; }
  friend bool operator!=(const Counting& a, const Counting& b) { return a.at_ != b.at_; }

 private:
  const char* begin_ = nullptr;
  const char* at_ = nullptr;
  std::size_t* count_ = nullptr;
};

class Builder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  Builder(std::string_view text, FileId file, const std::size_t& at) : text_(text), file_(file), at_(at) {}

  bool null() { return word(4, {}); }
  bool boolean(bool value) {
    JsonValue result;
    result.kind = JsonValue::Kind::boolean;
    result.truth = value;
    return word(value ? 4 : 5, std::move(result));
  }
  bool number_integer(number_integer_t value) { return number(static_cast<double>(value), true); }
  bool number_unsigned(number_unsigned_t value) { return number(static_cast<double>(value), true); }
  bool number_float(number_float_t value, const string_t&) { return number(value, false); }
  bool string(string_t& value) {
    JsonValue result;
    result.kind = JsonValue::Kind::text;
    result.text = value;
    result.where = quoted();
    return add(std::move(result));
  }
  bool binary(binary_t&) { return false; }  // only other formats than JSON have it
  bool key(string_t& value) {
    open_.back().members.push_back({value, quoted(), {}});
    return true;
  }
  bool start_object(std::size_t) { return start(JsonValue::Kind::object); }
  bool start_array(std::size_t) { return start(JsonValue::Kind::array); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& problem) {
    const std::size_t place = position == 0 ? 0 : position - 1;
    error_at_ = static_cast<std::uint32_t>(std::min(place, text_.size()));
    error_ = problem.what();
    return false;
  }

  JsonValue take() { return std::move(root_); }
  SourceSpan error_place() const { return {file_, error_at_, error_at_}; }
  const std::string& error() const { return error_; }

 private:
  std::uint32_t offset(std::size_t at) const { return static_cast<std::uint32_t>(at); }

  /// The reader has just passed the closing quote.
  SourceSpan quoted() const {
    std::size_t begin = at_ - 1;
    while (begin > 0) {
      --begin;
      if (text_[begin] != '"') continue;
      std::size_t slashes = 0;
      while (slashes < begin && text_[begin - slashes - 1] == '\\') ++slashes;
      if (slashes % 2 == 0) break;
    }
    return {file_, offset(begin), offset(at_)};
  }
  bool word(std::size_t length, JsonValue value) {
    value.where = {file_, offset(at_ - length), offset(at_)};
    return add(std::move(value));
  }
  /// The reader has passed the number and, unless the text ends there, one character more.
  bool number(double value, bool whole) {
    const auto belongs = [&](std::size_t i) {
      return std::string_view("0123456789+-.eE").find(text_[i]) != std::string_view::npos;
    };
    std::size_t last = at_;
    if (last > 0 && !belongs(last - 1)) --last;
    std::size_t begin = last;
    while (begin > 0 && belongs(begin - 1)) --begin;
    JsonValue result;
    result.kind = JsonValue::Kind::number;
    result.number = value;
    result.whole = whole;
    result.where = {file_, offset(begin), offset(last)};
    return add(std::move(result));
  }
  bool start(JsonValue::Kind kind) {
    if (open_.size() >= deepest) {
      error_ = "it is nested too deeply";
      error_at_ = offset(at_ - 1);
      return false;
    }
    JsonValue value;
    value.kind = kind;
    value.where = {file_, offset(at_ - 1), offset(at_)};
    open_.push_back(std::move(value));
    return true;
  }
  bool end() {
    JsonValue value = std::move(open_.back());
    value.end = offset(at_);
    open_.pop_back();
    return add(std::move(value));
  }
  bool add(JsonValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().kind == JsonValue::Kind::array) {
      open_.back().items.push_back(std::move(value));
    } else {
      open_.back().members.back().value = std::move(value);
    }
    return true;
  }

  std::string_view text_;
  FileId file_;
  const std::size_t& at_;
  std::vector<JsonValue> open_;
  JsonValue root_;
  std::string error_;
  std::uint32_t error_at_ = 0;
};

/// What the library says, without its own name, number and place.
std::string cause(const std::string& what) {
  const auto colon = what.find(": ");
  return what.starts_with("[json.") && colon != std::string::npos ? what.substr(colon + 2) : what;
}

}  // namespace

std::optional<JsonValue> parse_json(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const std::string_view text = sources.text(file);
  std::size_t at = 0;
  Builder builder(text, file, at);
  const char* begin = text.data();
  if (nlohmann::json::sax_parse(Counting(begin, begin, &at), Counting(begin, begin + text.size(), nullptr),
                                &builder))
    return builder.take();
  if (report_merge_conflict(text, file, diagnostics)) return std::nullopt;
  diagnostics.report(Finding::not_json, builder.error_place(), cause(builder.error()));
  return std::nullopt;
}

}  // namespace pal::operations
