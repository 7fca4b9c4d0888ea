#include "tests/support/refigured.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <vector>

#include "tests/support/any_skill.hpp"
#include "tests/support/lines.hpp"

namespace pal::test {
namespace {

class Figures {
 public:
  Figures(const std::string& text, std::mt19937_64& engine) : engine_(engine), lines_(lines_of(text)) {
    static const std::regex processor(R"(^\s*PROCESSOR\s+([\w-]+).*)");
    std::smatch found;
    for (const std::string& line : lines_) {
      if (std::regex_match(line, found, processor)) processors_.push_back(found[1]);
    }
    few_ = chance(2) == 0;
  }

  std::string text() {
    bool latency = false;
    for (std::string& line : lines_) {
      if (few_ && chance(3) > 0) continue;
      if (starts(line, "LATENCY")) latency = true;
      line = other(line);
    }
    if (!latency && chance(2) == 0) {
      const auto end = std::find_if(lines_.begin(), lines_.end(),
                                    [](const std::string& line) { return starts(line, "END ENVIRONMENT"); });
      if (end != lines_.end())
        lines_.insert(end, "  LATENCY BETWEEN PROCESSORS " + interval({"0", "0.5", "1", "2", "3"}));
    }
    return joined(lines_);
  }

 private:
  using Choice = std::vector<std::string>;

  std::size_t chance(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  const std::string& one_of(const Choice& from) { return from[chance(from.size())]; }

  static bool starts(const std::string& line, const std::string& with) {
    return line.compare(std::min(line.find_first_not_of(' '), line.size()), with.size(), with) == 0;
  }

  std::string interval(const Choice& from) {
    const std::string one = one_of(from);
    const std::string other = one_of(from);
    if (chance(2) == 0 || one == other) return one + " ms";
    const bool in_order = std::stod(one) < std::stod(other);
    return in_order ? one + " TO " + other + " ms" : other + " TO " + one + " ms";
  }

  std::string other(const std::string& line) {
    static const std::regex time(R"(^(\s*TIME\s+[\w-]+(?:\s+OF\s+[\w-]+)?\s*:\s*).*)");
    static const std::regex cost(R"(^(\s*COST\s+\w+\s+).*)");
    static const std::regex latency(R"(^(\s*LATENCY\s+\w+\s+\w+\s+).*)");
    static const std::regex place(R"(^(\s*PLACE\s+\S+\s+ON\s+)([\w-]+)(\s+PRIORITY\s+)(\d+).*)");
    static const std::regex processor(R"(^(\s*PROCESSOR\s+[\w-]+).*)");
    static const std::regex asked(R"(^(\s*DEVICE\s+[\w-]+\s+)ON REQUEST\s.*)");
    static const std::regex frames(R"(^(\s*DEVICE\s+[\w-]+\s+)FRAMES\s.*)");
    static const std::regex event(R"(^(\s*DEVICE\s+[\w-]+\s+EVENT\s+(?:request\s+)?[\w-]+).*)");
    static const std::regex limit(R"(^(\s*WTM.*WITHIN\s+)[\d.]+\s*\w+(.*))");
    std::smatch found;
    if (std::regex_match(line, found, time))
      return found[1].str() + interval({"0.5", "1", "1", "1.5", "2", "3", "4", "6"});
    if (std::regex_match(line, found, cost)) return found[1].str() + interval({"0", "0", "0.1", "0.5"});
    if (std::regex_match(line, found, latency)) return found[1].str() + interval({"0", "0.5", "1", "2", "3"});
    if (std::regex_match(line, found, place)) {
      const std::string on = chance(2) == 0 ? one_of(processors_) : found[2].str();
      return found[1].str() + on + found[3].str() +
             (chance(2) == 0 ? one_of({"1", "2", "3"}) : found[4].str());
    }
    if (std::regex_match(line, found, processor))
      return found[1].str() + (chance(5) == 0 ? " NONPREEMPTIVE" : "");
    if (std::regex_match(line, found, asked))
      return found[1].str() + "ON REQUEST " + interval({"0", "0.5", "1", "2", "3", "4", "6", "10"});
    if (std::regex_match(line, found, frames))
      return found[1].str() + "FRAMES EVERY " + one_of(periods()) + " ms COLLECTING " +
             one_of({"1", "2", "3", "4"}) + " ms";
    if (std::regex_match(line, found, event)) return device(found[1].str(), line);
    if (std::regex_match(line, found, limit) && chance(2) == 0)
      return found[1].str() + one_of({"0", "1", "2", "3", "5", "8", "10"}) + " ms" + found[2].str();
    return line;
  }

  static const Choice& periods() {
    static const Choice all = {"6", "8", "10", "11", "11.5", "12", "14", "15", "20", "25", "30", "40"};
    return all;
  }

  /// One that sends by itself; what it wants as an answer it gets before its next event.
  std::string device(const std::string& head, const std::string& line) {
    static const std::regex answer(R"(.*\bANSWER\s+([\w-]+).*)");
    const std::string period = one_of(periods());
    const std::string jitter = chance(5) == 0 ? one_of({"0.5", "1", "2", "3"}) : "";
    const bool sporadic = chance(8) == 0;
    std::string made = head + (sporadic ? " SPORADIC " : " EVERY ") + period + " ms";
    if (!jitter.empty()) made += " JITTER " + jitter + " ms";
    if (!sporadic && chance(3) == 0) made += " PHASE " + one_of({"0", "0", "1", "2", "3", "5"}) + " ms";
    std::smatch found;
    if (!std::regex_match(line, found, answer)) return made;
    const double within = std::stod(period) - (jitter.empty() ? 0 : std::stod(jitter));
    return made + " ANSWER " + found[1].str() + " WITHIN " + std::to_string(within) + " ms";
  }

  std::mt19937_64& engine_;
  Lines lines_;
  Choice processors_;
  bool few_ = false;
};

/// All that can be asked of a skill, and more: what has no meaning is left out later.
class Questions {
 public:
  explicit Questions(const analyzer::Problem& problem) {
    for (const analyzer::Device& device : problem.devices) devices_.insert(device.name);
    for (const analyzer::Statement& statement : problem.statements) find(statement);
    for (const analyzer::Device& device : problem.devices) {
      all_.push_back("LOSS OF " + device.name + " NONE");
      if (!device.event.valid()) continue;
      const std::string& event = problem.channels[device.event].message;
      causes_.insert(event + " OF " + device.name);
    }
    values_.insert(problem.conditions.begin(), problem.conditions.end());
    for (const std::string& at : places_) {
      const std::string most = " AT MOST 900 ms";
      all_.push_back("INTERVAL OF " + at + most);
      all_.push_back("INTERVAL OF " + at + " AT LEAST 1 us");
      for (const std::string& cause : causes_) all_.push_back("RESPONSE FROM " + cause + " TO " + at + most);
      for (const std::string& value : values_) {
        all_.push_back("AGE OF " + value + " AT " + at + most);
        all_.push_back("REACTION OF " + value + " AT " + at + most);
      }
    }
    all_.emplace_back("BUSY PERIOD OF EACH PROCESSOR AT MOST 900 ms");
    all_.emplace_back("LOAD OF EACH PROCESSOR AT MOST 90 %");
  }

  std::vector<std::string>& all() { return all_; }

 private:
  /// Where it can be asked for something, what it sends, and what it takes from a device.
  void find(const analyzer::Statement& statement) {
    static const std::regex sends(R"(TXM\( (request )?([\w-]+) (?:to|from) .*)");
    static const std::regex takes(R"(WTM\( ([\w-]+) from ([\w-]+) \).*)");
    places_.insert(statement.text.substr(0, statement.text.find(" WITHIN ")) + " IN " + statement.module);
    std::smatch found;
    if (std::regex_match(statement.text, found, sends))
      causes_.insert(found[1].str() + found[2].str() + " OF " + statement.module);
    if (std::regex_match(statement.text, found, takes) && devices_.contains(found[2]))
      values_.insert(found[1].str() + " FROM " + found[2].str());
  }

  std::set<std::string> devices_;
  std::set<std::string> places_;
  std::set<std::string> causes_;
  std::set<std::string> values_;
  std::vector<std::string> all_;
};

}  // namespace

std::string refigured(const std::string& text, std::mt19937_64& engine) {
  return Figures(text, engine).text();
}

std::string asked_everything(const std::string& text, std::mt19937_64& engine, std::size_t most) {
  const auto skill = any_skill(text);
  if (!skill->problem) return text;
  static const std::regex requirement(R"(^\s*REQUIREMENT\b.*)");
  static const std::regex end(R"(^\s*END SKILL\b.*)");
  Lines lines = lines_of(text);
  std::erase_if(lines, [](const std::string& line) { return std::regex_match(line, requirement); });
  const auto place = static_cast<std::size_t>(
      std::find_if(lines.begin(), lines.end(),
                   [](const std::string& line) { return std::regex_match(line, end); }) -
      lines.begin());
  if (place == lines.size()) return text;
  std::vector<std::string> questions = Questions(*skill->problem).all();
  std::shuffle(questions.begin(), questions.end(), engine);
  std::string asked = text;
  std::size_t count = 0;
  for (const std::string& question : questions) {
    if (count == most) break;
    Lines more = lines;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(place),
                "  REQUIREMENT asked-" + std::to_string(count) + " : " + question);
    std::string made = joined(more);
    if (!any_skill(made)->problem) continue;
    asked = std::move(made);
    lines = std::move(more);
    ++count;
  }
  return asked;
}

}  // namespace pal::test
