#include "programs/pal/options/option_values.hpp"

#include <charconv>
#include <chrono>
#include <cstdint>

#include "pal/support/duration_text.hpp"

namespace pal::program {

CLI::Validator whole_number() {
  const auto complaint = [](const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end == text.data() + text.size() && error == std::errc()) return std::string();
    return "'" + text + "' is not a whole number from 0 on" +
           (error == std::errc::result_out_of_range ? ", of 64 bits" : "");
  };
  return CLI::Validator(complaint, "");
}

Duration duration_of(const std::string& text, const char* option) {
  const std::size_t end = text.find_first_not_of("0123456789.");
  const std::string number = text.substr(0, end);
  const std::size_t unit = end == std::string::npos ? end : text.find_first_not_of(' ', end);
  const auto duration = parse_duration(number, unit == std::string::npos ? "s" : text.substr(unit));
  if (const auto* time = std::get_if<Duration>(&duration)) return *time;
  throw CLI::ValidationError(option, "'" + text + "' is no length of time, as 90 s or 500 ms is");
}

void add_timeout(CLI::App& command, double& seconds, const char* description) {
  command
      .add_option_function<std::string>(
          "--timeout",
          [&seconds](const std::string& text) {
            seconds = std::chrono::duration<double>(duration_of(text, "--timeout")).count();
          },
          description)
      ->type_name("DURATION");
}

}  // namespace pal::program
