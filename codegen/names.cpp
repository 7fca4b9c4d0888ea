#include "codegen/names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace pal::codegen {

namespace {

// Of C++20, the alternative tokens included, and the macros that a C library or gnu++20 may define.
constexpr std::array keywords{
    "alignas",       "alignof",     "and",       "and_eq",       "asm",       "auto",
    "bitand",        "bitor",       "bool",      "break",        "case",      "catch",
    "char",          "char16_t",    "char32_t",  "char8_t",      "class",     "co_await",
    "co_return",     "co_yield",    "compl",     "concept",      "const",     "const_cast",
    "consteval",     "constexpr",   "constinit", "continue",     "decltype",  "default",
    "delete",        "do",          "double",    "dynamic_cast", "else",      "enum",
    "errno",         "explicit",    "export",    "extern",       "false",     "float",
    "for",           "friend",      "goto",      "i386",         "if",        "inline",
    "int",           "linux",       "long",      "mutable",      "namespace", "new",
    "noexcept",      "not",         "not_eq",    "nullptr",      "operator",  "or",
    "or_eq",         "private",     "protected", "public",       "register",  "reinterpret_cast",
    "requires",      "return",      "short",     "signed",       "sizeof",    "static",
    "static_assert", "static_cast", "stderr",    "stdin",        "stdout",    "struct",
    "switch",        "template",    "this",      "thread_local", "throw",     "true",
    "try",           "typedef",     "typeid",    "typename",     "union",     "unix",
    "unsigned",      "using",       "virtual",   "void",         "volatile",  "wchar_t",
    "while",         "xor",         "xor_eq"};

bool is_keyword(const std::string& name) {
  return std::find(keywords.begin(), keywords.end(), name) != keywords.end();
}

bool word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}
bool digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}
char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

}  // namespace

std::string snake_words(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (word_character(c)) {
      result += lower(c);
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  return result;
}

std::string snake_case(std::string_view name) {
  const std::string words = snake_words(name);
  const bool apart = words.empty() || digit(words.front()) || is_keyword(words);
  return apart ? "pal_" + words : words;
}

std::string camel_case(std::string_view name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (!word_character(c)) {
      begins = true;
      continue;
    }
    result += begins ? upper(c) : c;
    begins = false;
  }
  if (result.empty() || digit(result.front())) result.insert(0, "N");
  return result;
}

std::string literal(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '\n') {
      result += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string Scope::unique(const std::string& wish) {
  std::string name = wish;
  for (int number = 2; !taken_.insert(name).second; ++number) {
    name = wish + (digit(wish.back()) ? "_" : "") + std::to_string(number);
  }
  return name;
}

}  // namespace pal::codegen
