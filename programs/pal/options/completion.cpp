#include "programs/pal/options/completion.hpp"

#include <algorithm>
#include <functional>
#include <sstream>

#include "programs/pal/options/option_values.hpp"

namespace pal::program {
namespace {

const std::function<bool(CLI::App*)> every;
const std::function<bool(CLI::Option*)> all;

/// A command with those above it: {"operation", "check"}.
struct Entry {
  std::vector<std::string> path;
  CLI::App* app;
};

void collect(CLI::App& app, std::vector<std::string> path, std::vector<Entry>& entries) {
  entries.push_back({path, &app});
  for (CLI::App* command : app.get_subcommands(every)) {
    path.push_back(command->get_name());
    collect(*command, path, entries);
    path.pop_back();
  }
}

std::vector<std::string> words_of(CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* command : app.get_subcommands(every)) words.push_back(command->get_name());
  for (CLI::Option* option : app.get_options(all)) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    for (const std::string& name : option->get_snames()) words.push_back("-" + name);
  }
  return words;
}

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
  std::string result;
  for (const std::string& word : words) result += (&word == &words.front() ? "" : between) + word;
  return result;
}

/// Text in single quotes of a shell.
std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// The first sentence, for a list.
std::string brief(const std::string& text) {
  return text.substr(0, std::min({text.find(';'), text.find('\n'), text.find(". "), text.size()}));
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

std::string bash(const CLI::App& app, const std::vector<Entry>& entries) {
  const std::string name = app.get_name();
  std::string out =
      "# bash completion of " + name + ", written by: " + name + " completion bash\n_" + name +
      "() {\n  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} path= i\n"
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n    case \"$path ${COMP_WORDS[i]}\" in\n";
  for (const Entry& entry : entries) {
    if (!entry.path.empty())
      out += "      " + in_quotes(" " + joined(entry.path)) + ") path=\"$path ${COMP_WORDS[i]}\" ;;\n";
  }
  out += "    esac\n  done\n  case \"$path $before\" in\n";
  for (const Entry& entry : entries) {
    const std::string path = entry.path.empty() ? "" : " " + joined(entry.path);
    for (CLI::Option* option : entry.app->get_options(all)) {
      const auto choices = choices_of(*option);
      for (const std::string& word : option->get_lnames()) {
        if (!choices.empty())
          out += "    " + in_quotes(path + " --" + word) + ") COMPREPLY=($(compgen -W " +
                 in_quotes(joined(choices)) + " -- \"$word\")); return ;;\n";
      }
    }
  }
  out += "  esac\n  case \"$path\" in\n";
  for (const Entry& entry : entries) {
    const std::string path = entry.path.empty() ? "" : " " + joined(entry.path);
    out += "    " + in_quotes(path) + ") COMPREPLY=($(compgen -W " + in_quotes(joined(words_of(*entry.app))) +
           " -- \"$word\")) ;;\n";
  }
  return out +
         "  esac\n  [[ $word == -* ]] || COMPREPLY+=($(compgen -f -- \"$word\"))\n}\ncomplete -o filenames "
         "-F _" +
         name + " " + name + "\n";
}

std::string zsh(const CLI::App& app, const std::vector<Entry>& entries) {
  const std::string name = app.get_name();
  const auto in_brackets = [](std::string text) {
    std::string result;
    for (const char c : text)
      result += std::string("[]:\\").find(c) == std::string::npos ? std::string(1, c) : std::string("\\") + c;
    return result;
  };
  std::string out = "#compdef " + name + "\n# zsh completion of " + name + ", written by: " + name +
                    " completion zsh\n_" + name +
                    "() {\n  local way= i\n  local -a commands\n"
                    "  for ((i = 2; i < CURRENT; ++i)); do\n    case \"$way ${words[i]}\" in\n";
  for (const Entry& entry : entries) {
    if (!entry.path.empty())
      out += "      " + in_quotes(" " + joined(entry.path)) + ") way=\"$way ${words[i]}\" ;;\n";
  }
  out += "    esac\n  done\n  case \"$way\" in\n";
  for (const Entry& entry : entries) {
    out += "    " + in_quotes(entry.path.empty() ? "" : " " + joined(entry.path)) + ")\n";
    const auto commands = entry.app->get_subcommands(every);
    if (!commands.empty()) {
      out += "      commands=(";
      for (const CLI::App* command : commands)
        out += " " + in_quotes(command->get_name() + ":" + in_brackets(brief(command->get_description())));
      out += " )\n      _describe command commands\n";
    }
    out += "      _arguments";
    for (CLI::Option* option : entry.app->get_options(all)) {
      const auto choices = choices_of(*option);
      for (const std::string& word : option->get_lnames()) {
        std::string spec = "*--" + word + "[" + in_brackets(brief(option->get_description())) + "]";
        if (takes_value(*option))
          spec += ":value:" + (choices.empty() ? std::string("_files") : "(" + joined(choices) + ")");
        out += " \\\n        " + in_quotes(spec);
      }
    }
    out += " \\\n        '*:file:_files' ;;\n";
  }
  return out + "  esac\n}\n_" + name + " \"$@\"\n";
}

std::string fish(const CLI::App& app, const std::vector<Entry>& entries) {
  const std::string name = app.get_name();
  std::string out = "# fish completion of " + name + ", written by: " + name + " completion fish\n";
  for (const Entry& entry : entries) {
    std::string when =
        entry.path.empty() ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + entry.path.front();
    if (entry.path.size() > 1) when += "; and __fish_seen_subcommand_from " + entry.path[1];
    const std::string line = "complete -c " + name + " -n " + in_quotes(when);
    for (const CLI::App* command : entry.app->get_subcommands(every))
      out += line + " -f -a " + command->get_name() + " -d " + in_quotes(brief(command->get_description())) +
             "\n";
    for (CLI::Option* option : entry.app->get_options(all)) {
      if (option->get_lnames().empty()) continue;
      const auto choices = choices_of(*option);
      out += line + " -l " + option->get_lnames().front();
      for (const std::string& letter : option->get_snames()) out += " -s " + letter;
      if (takes_value(*option)) out += choices.empty() ? " -r" : " -x -a " + in_quotes(joined(choices));
      out += " -d " + in_quotes(brief(option->get_description())) + "\n";
    }
  }
  return out;
}

}  // namespace

const std::vector<std::string>& known_shells() {
  static const std::vector<std::string> shells{"bash", "zsh", "fish"};
  return shells;
}

std::string completion_script(CLI::App& app, const std::string& shell) {
  std::vector<Entry> entries;
  collect(app, {}, entries);
  return shell == "bash" ? bash(app, entries) : shell == "zsh" ? zsh(app, entries) : fish(app, entries);
}

std::vector<std::string> choices_of(CLI::Option& option) {
  std::vector<std::string> words;
  try {
    const std::string& name = option.get_validator(0)->get_name();
    if (!name.starts_with(choices_prefix)) return words;
    std::istringstream list(name.substr(choices_prefix.size()));
    for (std::string word; list >> word;) words.push_back(word);
  } catch (const CLI::OptionNotFound&) {  // it has no validator
  }
  return words;
}

void add_completion(CLI::App& app, std::string& shell) {
  CLI::App* command = app.add_subcommand("completion", "Prints a script by which a shell completes commands");
  command->add_option("shell", shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember(known_shells()))
      ->type_name("SHELL");
  command->footer("bash: source <(" + app.get_name() + " completion bash); zsh: " + app.get_name() +
                  " completion zsh > a folder of fpath, as _" + app.get_name() + "; fish: " + app.get_name() +
                  " completion fish > ~/.config/fish/completions/" + app.get_name() +
                  ".fish. The packages install all three.");
}

}  // namespace pal::program
