// A scene file as a description of the cell.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "sim/model/scene_description.hpp"

namespace pal::sim {
namespace {

struct Word {
  std::string text;
  bool quoted = false;
};

std::string joined_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string shortest_text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::optional<double> number_in(const std::string& text) {
  const char* begin = text.c_str() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
  const char* end = text.c_str() + text.size();
  double value = 0;
  const auto [stop, problem] = std::from_chars(begin, end, value);
  if (problem != std::errc() || stop != end || !(value > -1e12 && value < 1e12)) return std::nullopt;
  return value;
}

class SceneReader {
 public:
  explicit SceneReader(std::string file) : file_(std::move(file)) {}

  SceneDescription read(std::string_view text) {
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
      ++line_;
      words_ = split(line);
      at_ = 0;
      if (!words_.empty()) read_line(line);
    }
    finish();
    return std::move(scene_);
  }

 private:
  [[noreturn]] void fail(const std::string& cause, const std::string& hint, int line = 0) const {
    throw SceneError(file_ + ":" + std::to_string(line == 0 ? line_ : line), cause, hint);
  }

  std::vector<Word> split(const std::string& line) const {
    std::vector<Word> words;
    for (std::size_t i = 0; i < line.size();) {
      const char c = line[i];
      if (c == '#') break;
      if (c == ' ' || c == '\t' || c == '\r') {
        ++i;
      } else if (c == '"') {
        const std::size_t end = line.find('"', i + 1);
        if (end == std::string::npos)
          fail("a quotation mark is not closed", "write a name as \"left plate\"");
        words.push_back({line.substr(i + 1, end - i - 1), true});
        i = end + 1;
      } else {
        const std::size_t end = std::min(line.find_first_of(" \t\r#\"", i), line.size());
        words.push_back({line.substr(i, end - i), false});
        i = end;
      }
    }
    return words;
  }

  void read_line(const std::string& line) {
    const std::string first = words_[at_++].text;
    if (first == "about") return read_about(line);
    if (first == "tool") return read_tool();
    if (first == "start") return read_start_line();
    if (first == "configuration") return read_configuration();
    if (first == "location") return read_location();
    if (first == "sensor") return read_sensor();
    if (first == "machine") return read_machine();
    if (first == "sensors") return read_sensors();
    if (first == "no") return read_no();
    const auto& kinds = thing_kinds();
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const ThingKind& known) { return known.name == first; });
    if (kind != kinds.end()) return read_thing(*kind);
    std::vector<std::string> names{"about",  "tool",    "start",   "configuration", "location",
                                   "sensor", "machine", "sensors", "no table"};
    for (const ThingKind& known : kinds) names.emplace_back(known.name);
    fail("'" + first + "' is not something that a scene has", "a line begins with " + joined_words(names));
  }

  void read_about(const std::string& line) {
    only_once("about");
    const std::size_t begin = line.find_first_not_of(" \t", line.find("about") + 5);
    if (begin == std::string::npos) fail("'about' needs a text", "write what the scene is in a few words");
    scene_.about = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
  }

  void read_tool() {
    only_once("tool");
    const std::string name = at_ < words_.size() ? words_[at_++].text : "";
    const auto tool = parse_tool(name);
    if (!tool) fail("'" + name + "' is not a tool", "write tool pad, tool gripper or tool range-finder");
    scene_.tool = *tool;
    nothing_left();
  }

  void read_start_line() {
    only_once("start");
    scene_.start_line = line_;
    scene_.start = read_tip("start", "write start X Y Z TURN: where the tool's tip begins");
  }

  // X Y Z TURN, to the end of the line; the turn may be left out.
  std::array<double, 4> read_tip(const std::string& what, const std::string& usage) {
    std::array<double, 4> tip{};
    for (std::size_t i = 0; i < tip.size(); ++i) {
      if (i == 3 && at_ == words_.size()) break;
      const auto value = at_ < words_.size() ? number_in(words_[at_].text) : std::nullopt;
      if (!value)
        fail(at_ < words_.size() ? "'" + words_[at_].text + "' is not a number"
                                 : "the " + what + " has too few figures",
             usage + ", in mm from the shoulder, and how far it is turned about the vertical, in degrees");
      tip[i] = *value;
      ++at_;
    }
    nothing_left();
    return tip;
  }

  void read_location() {
    const std::string usage = "write location NAME X Y Z TURN: where VAL has been taught that the tip is";
    const std::string name = at_ < words_.size() ? words_[at_++].text : "";
    constexpr std::size_t longest = 20;
    const auto capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const auto fits = [&](char c) { return capital(c) || (c >= '0' && c <= '9') || c == '_'; };
    if (name.empty() || name.size() > longest || !capital(name[0]) ||
        !std::all_of(name.begin(), name.end(), fits))
      fail("'" + name + "' is not a name of VAL",
           usage + "; a name has up to 20 capitals, digits and underscores and begins with a capital");
    const auto taught = [&](const DescribedLocation& known) { return known.name == name; };
    if (std::any_of(scene_.locations.begin(), scene_.locations.end(), taught))
      fail("location " + name + " is said twice", "take one of them out");
    scene_.locations.push_back({name, read_tip("location", usage)});
  }

  void read_sensor() {
    const std::string usage = "write sensor NAME at X Y Z: a distance sensor that looks straight down";
    DescribedSensor sensor{at_ < words_.size() ? words_[at_++].text : "", {}};
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    if (sensor.name.empty() || sensor.name == "at" ||
        !std::all_of(sensor.name.begin(), sensor.name.end(), fits))
      fail("'" + sensor.name + "' is not a name of a sensor",
           usage + "; a name has lower-case letters, digits and '-'");
    for (const char* taken : {"force-", "torque-", "gripper-", "range-"})
      if (sensor.name.starts_with(taken))
        fail("sensor '" + sensor.name + "' begins as those of the arm do", "give it another name");
    const auto known = [&](const DescribedSensor& other) { return other.name == sensor.name; };
    if (std::any_of(scene_.sensors.begin(), scene_.sensors.end(), known))
      fail("sensor " + sensor.name + " is said twice", "take one of them out");
    if (at_ >= words_.size() || words_[at_++].text != "at")
      fail("the sensor does not say where it stands", usage);
    for (double& figure : sensor.at) {
      const auto value = at_ < words_.size() ? number_in(words_[at_].text) : std::nullopt;
      if (!value)
        fail(at_ < words_.size() ? "'" + words_[at_].text + "' is not a number"
                                 : "the sensor has too few figures",
             usage + ", in mm from the shoulder");
      figure = *value;
      ++at_;
    }
    nothing_left();
    scene_.sensors.push_back(std::move(sensor));
  }

  void read_configuration() {
    only_once("configuration");
    std::string words;
    for (; at_ < words_.size(); ++at_) words += (words.empty() ? "" : " ") + words_[at_].text;
    const auto configuration = parse_configuration(words);
    if (!configuration)
      fail("'" + words + "' is not a configuration of the arm",
           "write righty or lefty, above or below, flip or noflip");
    scene_.configuration = *configuration;
  }

  void read_machine() {
    only_once("machine");
    const std::string hint =
        "write machine exact, machine without counts, machine without play, or machine seed NUMBER";
    const std::string word = at_ < words_.size() ? words_[at_++].text : "";
    if (word == "exact") {
      scene_.machine.encoders = scene_.machine.backlash = false;
    } else if (word == "without") {
      const std::string what = at_ < words_.size() ? words_[at_++].text : "";
      if (what != "counts" && what != "play")
        fail("'" + what + "' is not something that a machine can be without", hint);
      (what == "counts" ? scene_.machine.encoders : scene_.machine.backlash) = false;
    } else if (word == "seed") {
      const std::string text = at_ < words_.size() ? words_[at_++].text : "";
      std::uint64_t seed = 0;
      const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), seed);
      if (problem != std::errc() || stop != text.data() + text.size() || text.empty())
        fail("'" + text + "' is not a seed, which is a whole number from 0 on", hint);
      scene_.machine.seed = seed;
    } else {
      fail("'" + word + "' is not something that the machine can be", hint);
    }
    nothing_left();
  }

  void read_sensors() {
    only_once("sensors");
    if (at_ >= words_.size() || words_[at_++].text != "exact")
      fail("the sensors can only be exact", "write sensors exact");
    scene_.machine.noise = false;
    nothing_left();
  }

  void read_no() {
    if (at_ >= words_.size() || words_[at_++].text != "table")
      fail("only the table can be left out", "write no table");
    only_once("no table");
    scene_.table = false;
    nothing_left();
  }

  void read_thing(const ThingKind& kind) {
    Thing thing;
    thing.kind = kind.name;
    thing.line = line_;
    if (at_ < words_.size() && words_[at_].quoted) thing.name = words_[at_++].text;
    while (at_ < words_.size()) read_setting(kind, thing);
    for (const Setting& setting : kind.settings) {
      if (thing.given(setting.name)) continue;
      if (setting.needed)
        fail("this " + thing.kind + " does not say '" + std::string(setting.name) + "'", usage(setting));
      thing.figures[std::string(setting.name)] = {setting.usual.begin(), setting.usual.end()};
    }
    scene_.things.push_back(std::move(thing));
  }

  void read_setting(const ThingKind& kind, Thing& thing) {
    const std::string name = words_[at_++].text;
    const auto setting = std::find_if(kind.settings.begin(), kind.settings.end(),
                                      [&](const Setting& known) { return known.name == name; });
    if (setting == kind.settings.end()) {
      std::vector<std::string> names;
      for (const Setting& known : kind.settings) names.emplace_back(known.name);
      fail("a " + thing.kind + " has no '" + name + "'",
           "it can be told " + joined_words(names) + "; a name comes first, in quotation marks");
    }
    if (thing.given(name)) fail("'" + name + "' is said twice", "take one of them out");
    std::vector<double> figures;
    for (; at_ < words_.size() && figures.size() < setting->most; ++at_) {
      const auto value = number_in(words_[at_].text);
      if (!value) break;
      if (*value < setting->low || *value > setting->high)
        fail("'" + name + "' is " + words_[at_].text + ", which is out of its range",
             "write a value from " + shortest_text(setting->low) + " to " + shortest_text(setting->high) +
                 " " + std::string(setting->unit));
      figures.push_back(*value);
    }
    if (figures.size() < setting->least)
      fail(at_ < words_.size() && figures.empty()
               ? "'" + words_[at_].text + "' is not a number"
               : "'" + name + "' has " + std::to_string(figures.size()) + " figures instead of " +
                     std::to_string(setting->least),
           usage(*setting));
    for (std::size_t i = figures.size(); i < setting->most; ++i) figures.push_back(setting->usual[i]);
    thing.figures[name] = std::move(figures);
    thing.said.push_back(name);
  }

  static std::string usage(const Setting& setting) {
    std::string text = "write " + std::string(setting.name);
    static constexpr std::array<const char*, 3> letters{" X", " Y", " Z"};
    for (std::size_t i = 0; i < setting.most; ++i) text += setting.most == 1 ? " N" : letters.at(i);
    if (setting.least < setting.most) text += ", of which the last may be left out";
    return text + (setting.unit.empty() ? "" : ", in " + std::string(setting.unit));
  }

  void nothing_left() const {
    if (at_ < words_.size())
      fail("'" + words_[at_].text + "' is one word too many", "remove it; # begins a comment");
  }

  void only_once(const std::string& what) {
    if (std::find(said_.begin(), said_.end(), what) != said_.end())
      fail("'" + what + "' is said twice", "take one of them out");
    said_.push_back(what);
  }

  // Names for what has none: "plate", or "post 1", "post 2" where there are several.
  void finish() {
    if (!scene_.start)
      fail("the scene does not say where the tool starts", "add a line: start X Y Z, in mm from the shoulder",
           std::max(line_, 1));
    std::map<std::string, int> count, used;
    for (const Thing& thing : scene_.things) ++count[thing.kind];
    std::vector<std::string> names{"table", "floor", "base",        "link1",        "link2",
                                   "link3", "link4", "link5",       "link6",        "sensor",
                                   "tool",  "pad",   "finger left", "finger right", "range finder"};
    for (Thing& thing : scene_.things) {
      const int serial = ++used[thing.kind];
      if (thing.name.empty())
        thing.name = thing.kind + (count[thing.kind] > 1 ? " " + std::to_string(serial) : "");
      if (std::any_of(thing.name.begin(), thing.name.end(), [](unsigned char c) {
            return c < ' ' || c == '<' || c == '>' || c == '&' || c == '/';
          }))
        fail("the name '" + thing.name + "' has a character that names cannot have",
             "leave out < > & / and control characters", thing.line);
      if (std::find(names.begin(), names.end(), thing.name) != names.end())
        fail("there is more than one thing named '" + thing.name + "'", "give it another name", thing.line);
      names.push_back(thing.name);
      check_ground(thing);
    }
  }

  // Whatever is sunk into the floor or into the table's top is neither seen nor felt as its line says.
  void check_ground(const Thing& thing) const {
    constexpr double rounding = 1e-6, table_thickness = 40;  // mm
    constexpr std::array<double, 2> middle{550, -200}, half{280, 360};
    const std::vector<double>& at = thing.all("at");
    if (at[2] < floor_height - rounding)
      fail("the underside of the " + thing.kind + " is at z = " + shortest_text(at[2]) + ", below the floor",
           "write a z from " + shortest_text(floor_height) + " on, the floor's height", thing.line);
    const bool over_table =
        scene_.table && std::abs(at[0] - middle[0]) < half[0] && std::abs(at[1] - middle[1]) < half[1];
    if (over_table && at[2] < table_top - rounding && at[2] > table_top - table_thickness)
      fail("the underside of the " + thing.kind + " is at z = " + shortest_text(at[2]) + ", inside the table",
           "leave out z: the thing then stands on the table, whose top is at " + shortest_text(table_top),
           thing.line);
  }

  std::string file_;
  int line_ = 0;
  std::vector<Word> words_;
  std::size_t at_ = 0;
  std::vector<std::string> said_;
  SceneDescription scene_;
};

}  // namespace

bool Thing::given(std::string_view setting) const {
  return std::find(said.begin(), said.end(), setting) != said.end();
}

SceneDescription parse_description(std::string_view text, const std::string& file) {
  return SceneReader(file).read(text);
}

SceneDescription read_description(const Scene& scene) {
  std::ifstream in(scene.file, std::ios::binary);
  if (!in)
    throw SceneError(scene.file.string(), "the file cannot be read", "check the path and its permissions");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return parse_description(text, scene.file.string());
}

}  // namespace pal::sim
