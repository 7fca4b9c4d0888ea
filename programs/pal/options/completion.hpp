// What a shell offers while a command is typed.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace pal::program {

/// The shells that a script can be written for: bash, zsh, fish.
const std::vector<std::string>& known_shells();

/// A script that completes the commands, options and words of `app`, made of its own descriptions. `shell` is
/// one of known_shells().
std::string completion_script(CLI::App& app, const std::string& shell);

/// The words that `add_choice` allows; empty: any text.
std::vector<std::string> choices_of(CLI::Option& option);

/// Adds the command `completion SHELL`, which stores its argument in `shell`.
void add_completion(CLI::App& app, std::string& shell);

}  // namespace pal::program
