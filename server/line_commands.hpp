// The words of a line as commands.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pal/pan/network.hpp"
#include "server/command.hpp"

namespace pal::server {

using Words = std::vector<std::string>;

Words words_of(const std::string& line);

/// A command, or what is wrong with its words.
template <class What>
using FromWords = std::variant<What, std::string>;

/// The skill's name, then values in the order of its parameters, or name=value.
FromWords<RunSkill> run_skill_of(const pan::Template& skill, const Words& words);
/// set ICON PARAMETER VALUE
SetParameter set_parameter_of(const Words& words);
/// break ICON [CODE]
FromWords<SetBreakpoint> set_breakpoint_of(const Words& words);
/// answer ICON ANSWER: its place from 0, or its text.
AnswerQuestion answer_of(const Words& words);

}  // namespace pal::server
