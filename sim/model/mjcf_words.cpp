// MuJoCo's messages in the words of a scene's author.
#include <regex>

#include "sim/model/mjcf_file.hpp"

namespace pal::sim {
namespace {

std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool space = c == '\n' || c == '\r' || c == ' ';
    if (!space) line += c;
    if (space && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

/// What MuJoCo says, and what we say instead.
struct Words {
  std::regex said;
  const char* cause;  // with $1, $2 as std::regex_replace takes them
  const char* hint;
};

const std::vector<Words>& all_words() {
  static const std::vector<Words> words = [] {
    const auto row = [](const char* said, const char* cause, const char* hint) {
      return Words{std::regex(std::string(".*?") + said + ".*"), cause, hint};
    };
    return std::vector<Words>{
        row("problem reading attribute '([^']*)'", "'$1' is not a number",
            "write figures with blanks between"),
        row("attribute '([^']*)' does not have enough data", "'$1' has too few figures",
            "write as many as MuJoCo's reference of MJCF says"),
        row("attribute '([^']*)' has too much data", "'$1' has too many figures",
            "write as many as MuJoCo's reference of MJCF says"),
        row("required attribute missing: '([^']*)'", "the attribute '$1' is missing", "add $1=\"…\""),
        row("invalid keyword: '([^']*)'", "'$1' is not a word that may stand here",
            "see MuJoCo's reference of MJCF for the words"),
        row("unknown default class(?: name)? '?([^' ]*)'?", "there is no class '$1'",
            "define it in <default>, or take one of the machine's: cell"),
        row("(\\w+) '([^']*)' not found in (\\w+)", "there is no $1 '$2', which this $3 names",
            "check the name, or define it"),
        row("could not open \\w+ file '([^']*)'", "the file $1 cannot be read",
            "files are named from the scene's folder"),
        row("sizes must be positive in object '([^']*)'", "a size is missing or not above 0",
            "write size=\"…\" in metres; a box has half of its lengths"),
        row("size (\\d) must be positive in geom", "size $1 is missing or not above 0",
            "write size=\"…\" in metres; a box has half of its lengths"),
        row("plane size\\(3\\) must be positive", "a plane's third size is missing or not above 0",
            "write size=\"X Y GRID\""),
        row("mass and inertia of moving bodies must be larger", "a body that moves has no mass",
            "give it a geom with a mass or a density"),
        row("free joint can only be used on top level", "a body within another has a free joint",
            "move the body directly into <worldbody>"),
        row("plane and hfield only allowed in static bodies",
            "a plane or a height field is part of a body that moves", "leave out the body's joints"),
        row("inertia must satisfy A \\+ B >= C", "no body can have these moments of inertia",
            "two of them together are at least the third"),
        row("range\\[0\\] should be smaller than range\\[1\\]",
            "the lower end of a range is above its upper one", "exchange them"),
        row("fromto points too close", "the two points of 'fromto' are one", "move them apart"),
        row("more than 6 dofs", "a body has more than six degrees of freedom", "take joints out"),
    };
  }();
  return words;
}

}  // namespace

SceneError refusal_of(const MjcfFile& file, const Scene& scene, const std::string& said) {
  // MuJoCo says where in several ways: "Element 'gem', line 3", "line = 2, column = -1"; 0 is no place.
  static const std::regex where(R"([,\s(]*[Ll]ine(?: number)? ?=? ?(\d+)(?:, column = -?\d+)?\)?)");
  std::string text = one_line(said);
  std::string place = scene.file.string();
  for (std::sregex_iterator found(text.begin(), text.end(), where), end; found != end; ++found) {
    const std::size_t line = std::stoul((*found)[1]);
    if (line > 0 && line <= file.places.size()) place = file.places[line - 1];
  }
  text = std::regex_replace(text, where, "");
  for (const Words& words : all_words())
    if (std::regex_match(text, words.said))
      return {place, std::regex_replace(text, words.said, words.cause),
              std::regex_replace(text, words.said, words.hint)};
  text = std::regex_replace(text, std::regex("^(XML )?Error:? *"), "");
  return {place, "the element cannot be as it is", "MuJoCo 2.2.2 says of it: " + text};
}

}  // namespace pal::sim
