// What may stand behind an option: a word of some, a whole number, a length of time.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <string_view>

#include "pal/support/time.hpp"

namespace pal::program {

/// Begins the name of a validator that says which words an option takes; it checks nothing itself.
constexpr std::string_view choices_prefix = "choices: ";

/// One of the words of `values`.
template <typename Value>
CLI::Option* add_choice(CLI::App& command, const char* name, Value& value,
                        const std::map<std::string, Value>& values, const char* description) {
  const auto choose = [&value, values, name](const std::string& word) {
    if (const auto found = values.find(word); found != values.end()) {
      value = found->second;
      return;
    }
    std::string known;
    for (const auto& each : values) known += (known.empty() ? "" : ", ") + each.first;
    throw CLI::ValidationError(name, "'" + word + "' is none of " + known);
  };
  std::string words(choices_prefix);
  for (const auto& each : values) words += each.first + " ";
  return command.add_option_function<std::string>(name, choose, description)
      ->check(CLI::Validator([](const std::string&) { return std::string(); }, "", words));
}

/// Also refuses a number below 0, which would otherwise become a large one.
CLI::Validator whole_number();

/// "90", "90 s", "1.5min". Throws CLI::ValidationError of `option` for anything else.
Duration duration_of(const std::string& text, const char* option);

/// --timeout.
void add_timeout(CLI::App& command, double& seconds, const char* description);

}  // namespace pal::program
