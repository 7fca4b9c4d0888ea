// Skills with mistakes: a few lines and figures of a right skill changed at random.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/lines.hpp"

namespace pal::test {

/// Changes a skill step by step, and keeps each step that `accepts` takes. A step changes one of these:
/// - lines: left out, written twice, moved, or wrapped in another statement;
/// - figures and names: replaced by others;
/// - processors and devices: given another behaviour.
///
/// The same seed and text give the same mutant.
class Mutant {
 public:
  using Accepts = std::function<bool(const std::string&)>;

  Mutant(std::uint64_t seed, const std::string& text, Accepts accepts)
      : engine_(seed), accepts_(std::move(accepts)), lines_(lines_of(text)) {}

  /// `steps` changes that are accepted, or as many as are found in ten times as many tries.
  std::string text(int steps) {
    for (int tries = 0; tries < 10 * steps && steps > 0; ++tries) {
      Lines changed = lines_;
      change(changed);
      if (changed == lines_ || !accepts_(joined(changed))) continue;
      lines_ = std::move(changed);
      --steps;
    }
    return joined(lines_);
  }

 private:
  std::size_t chance(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  static auto at(Lines& lines, std::size_t index) {
    return lines.begin() + static_cast<std::ptrdiff_t>(index);
  }

  void change(Lines& lines) {
    const std::size_t line = chance(lines.size());
    switch (chance(16)) {
      case 0:
        lines.erase(at(lines, line));
        break;
      case 1:
        lines.insert(at(lines, line), lines[line]);
        break;
      case 2:
        std::swap(lines[line], lines[std::min(line + 1, lines.size() - 1)]);
        break;
      case 3:
        copy(lines, line);
        break;
      case 4:
      case 5:
        stretch(lines, line);
        break;
      case 6:
      case 7:
        wrap(lines, line);
        break;
      case 8:
        rename(lines, line);
        break;
      case 9:
      case 10:
      case 11:
        behave_otherwise(lines);
        break;
      default:
        count_otherwise(lines);
        break;
    }
  }

  /// To a place nearby.
  void copy(Lines& lines, std::size_t line) {
    const std::string copied = lines[line];
    const std::size_t low = line > 12 ? line - 12 : 0;
    lines.insert(at(lines, std::min(low + chance(25), lines.size())), copied);
  }

  /// Two to nine lines are left out, copied or moved to a place nearby.
  void stretch(Lines& lines, std::size_t line) {
    const auto begin = at(lines, line);
    const auto end = at(lines, std::min(line + 2 + chance(8), lines.size()));
    const Lines taken(begin, end);
    const std::size_t what = chance(3);
    if (what != 0) lines.erase(begin, end);
    if (what == 2) return;
    const std::size_t low = line > 20 ? line - 20 : 0;
    const auto to = at(lines, std::min(low + chance(40), lines.size()));
    lines.insert(to, taken.begin(), taken.end());
  }

  void wrap(Lines& lines, std::size_t line) {
    const std::string inner = lines[line];
    const std::string c = condition(lines);
    Lines around;
    switch (chance(5)) {
      case 0:
        around = {"REPEAT", inner, "UNTIL( " + c + " )"};
        break;
      case 1:
        around = {"CASE", "( " + c + " = TRUE ):", inner, "( " + c + " = FALSE ):", "Do Nothing", "END CASE"};
        break;
      case 2:
        around = {"CONCURRENT", "BEGIN", inner, "END", "BEGIN", "Do Nothing", "END", "END CONCURRENT"};
        break;
      case 3:
        around = {inner + " WITHIN " + std::to_string(1 + chance(9)) + " ms", "Do Nothing", "ELSE",
                  "Do Nothing", "END WTM"};
        break;
      default:
        around = {"REPEAT", inner, "UNTIL( forever )"};
        break;
    }
    lines.erase(at(lines, line));
    lines.insert(at(lines, line), around.begin(), around.end());
  }

  std::string condition(const Lines& lines) {
    Lines names;
    for (const std::string& line : lines) {
      std::istringstream words(line);
      std::string keyword;
      std::string name;
      if (words >> keyword >> name && keyword == "CONDITION") names.push_back(name);
    }
    return names.empty() ? "forever" : names[chance(names.size())];
  }

  /// One line of the environment says something else, or there is one more. Times are whole milliseconds.
  void behave_otherwise(Lines& lines) {
    std::vector<std::size_t> places;
    bool inside = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (inside) places.push_back(i);
      const Lines words = words_of(lines[i]);
      inside = inside || (!words.empty() && words.front() == "ENVIRONMENT");
    }
    if (places.empty()) return;
    static const Lines more = {"COST SEND 1 ms",
                               "COST RECEIVE 0 TO 1 ms",
                               "COST TEST 1 ms",
                               "COST SET 1 ms",
                               "LATENCY BETWEEN PROCESSORS 2 ms",
                               "LATENCY WITHIN PROCESSOR 1 ms",
                               "COST READ 0 TO 1 ms",
                               "LATENCY BETWEEN PROCESSORS 0 TO 3 ms"};
    if (chance(8) == 0) {
      lines.insert(at(lines, places.front()), more[chance(more.size())]);
      return;
    }
    std::string& line = lines[places[chance(places.size())]];
    const Lines words = words_of(line);
    if (words.empty()) return;
    if (words.front() == "PROCESSOR") {
      line = "PROCESSOR " + words.back() + " NONPREEMPTIVE";
      if (words.size() == 3) line = "PROCESSOR " + words[1];
    } else if (const auto every = line.find("EVERY"); every != std::string::npos && chance(2) == 0) {
      line.replace(every, 5, "SPORADIC");
    } else if (words.front() == "DEVICE") {
      static const Lines ends = {" JITTER 1 ms", " JITTER 3 ms", " PHASE 0 ms", " PHASE 2 ms"};
      line += ends[chance(ends.size())];
    } else if (const auto colon = line.find(" : "); colon != std::string::npos) {
      line.insert(colon + 3, chance(2) == 0 ? "0 TO " : "1 ms TO ");
    }
  }

  static Lines words_of(const std::string& line) {
    Lines words;
    std::istringstream in(line);
    for (std::string word; in >> word;) words.push_back(word);
    return words;
  }

  /// A word becomes one that stands on another line.
  void rename(Lines& lines, std::size_t line) {
    const Lines here = words_of(lines[line]);
    const Lines there = words_of(lines[chance(lines.size())]);
    if (here.empty() || there.empty()) return;
    const std::string& old = here[chance(here.size())];
    lines[line].replace(lines[line].find(old), old.size(), there[chance(there.size())]);
  }

  /// One number of the text becomes another whole one.
  void count_otherwise(Lines& lines) {
    struct Place {
      std::size_t line, from, length;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string& line = lines[i];
      for (std::size_t from = 0; from < line.size(); ++from) {
        if (!std::isdigit(static_cast<unsigned char>(line[from])) || (from > 0 && line[from - 1] != ' '))
          continue;
        std::size_t to = from;
        while (to < line.size() && (std::isdigit(static_cast<unsigned char>(line[to])) || line[to] == '.'))
          ++to;
        if (to == line.size() || line[to] == ' ') places.push_back({i, from, to - from});
        from = to;
      }
    }
    if (places.empty()) return;
    const Place place = places[chance(places.size())];
    std::string& line = lines[place.line];
    const double old = std::stod(line.substr(place.from, place.length));
    const double others[] = {0, 1, 2, 3, old + 1, old - 1, old * 2, old / 2, old * 3, old * 10};
    const auto now = static_cast<long long>(others[chance(std::size(others))]);
    line.replace(place.from, place.length, std::to_string(std::max(now, 0LL)));
  }

  std::mt19937_64 engine_;
  Accepts accepts_;
  Lines lines_;
};

}  // namespace pal::test
