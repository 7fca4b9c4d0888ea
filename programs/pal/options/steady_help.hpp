// Help that is the same in each run.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace pal::program {

/// CLI11 lists the options that one needs or excludes by where they lie in memory. Here they are in order.
class SteadyHelp : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    for (const auto& others : {option->get_needs(), option->get_excludes()}) {
      const auto at = text.find(listed(others, false));
      if (others.size() > 1 && at != std::string::npos)
        text.replace(at, listed(others, false).size(), listed(others, true));
    }
    return text;
  }

 private:
  static std::string listed(const std::set<CLI::Option*>& options, bool sorted) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options) names.push_back(option->get_name());
    if (sorted) std::sort(names.begin(), names.end());
    std::string text;
    for (const std::string& name : names) text += " " + name;
    return text;
  }
};

}  // namespace pal::program
