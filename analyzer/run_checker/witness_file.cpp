#include "analyzer/run_checker/witness_file.hpp"

#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace pal::analyzer::run_checker {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const FiledWitness& witness) {
  Json made;
  made["skill"] = witness.skill;
  made["environment"] = witness.environment;
  made["identity"] = witness.identity;
  for (const FiledPlacement& each : witness.placement)
    made["placement"].push_back(
        {{"thread", each.thread}, {"processor", each.processor}, {"priority", each.priority}});
  made["requirement"] = witness.requirement;
  made["measure"] = witness.measure;
  made["failed"] = witness.failed;
  made["grows"] = witness.grows;
  made["value_ns"] = witness.value;
  made["born_ns"] = witness.born;
  made["at_ns"] = witness.at;
  made["script"] = Json::array();
  for (const Firing& firing : witness.script) {
    made["script"].push_back({{"at_ns", firing.at}, {"timer", firing.timer}, {"choices", firing.choices}});
  }
  std::ostringstream run;
  trace::write_json(witness.run, run);
  made["run"] = Json::parse(run.str());
  return made;
}

/// Without the number that the library gives its errors.
std::string plain(const std::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return text.find("[json.exception") == 0 && end != std::string::npos ? text.substr(end + 2) : text;
}

/// A whole number of 64 bits with a sign, from `least` to `most`.
std::int64_t whole(const Json& value, const char* what,
                   std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                   std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
  const auto greatest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const bool fits =
      value.is_number_integer() && (!value.is_number_unsigned() || value.get<std::uint64_t>() <= greatest);
  if (!fits || value.get<std::int64_t>() < least || value.get<std::int64_t>() > most)
    throw std::runtime_error(std::string(what) + " is no whole number in its range");
  return value.get<std::int64_t>();
}

FiledPlacement placement_of(const Json& json) {
  constexpr int most = std::numeric_limits<int>::max();
  return {json.at("thread").get<std::string>(),
          static_cast<int>(whole(json.at("processor"), "processor", 0, most - 1)),
          static_cast<int>(whole(json.at("priority"), "priority", std::numeric_limits<int>::min(), most))};
}

Firing firing_of(const Json& json) {
  Firing made{whole(json.at("at_ns"), "at_ns"), json.at("timer").get<std::string>(), {}};
  if (!json.at("choices").is_array()) throw std::runtime_error("choices is no list");
  for (const Json& choice : json.at("choices"))
    made.choices.push_back(static_cast<std::uint8_t>(whole(choice, "a choice", 0, 255)));
  return made;
}

FiledWitness from_json(const Json& json) {
  FiledWitness made;
  made.skill = json.at("skill").get<std::string>();
  made.environment = json.at("environment").get<std::string>();
  made.identity = json.at("identity").get<std::string>();
  if (json.contains("placement")) {
    for (const Json& each : json.at("placement")) made.placement.push_back(placement_of(each));
  }
  made.requirement = json.at("requirement").get<std::string>();
  made.measure = json.at("measure").get<std::string>();
  made.failed = json.at("failed").get<bool>();
  made.grows = json.at("grows").get<bool>();
  made.value = whole(json.at("value_ns"), "value_ns");
  made.born = whole(json.at("born_ns"), "born_ns");
  made.at = whole(json.at("at_ns"), "at_ns");
  for (const Json& firing : json.at("script")) made.script.push_back(firing_of(firing));
  std::istringstream run(json.at("run").dump());
  made.run = trace::read_json(run);
  return made;
}

}  // namespace

std::string filed_text(const FiledWitness& witness) {
  std::string text;
  for (const char letter : to_json(witness).dump(1, ' ', false, Json::error_handler_t::replace)) {
    text += letter;
    if (letter == '\n') text += "  ";  // it stands in a list in an object
  }
  return text;
}

std::string file_of(const std::vector<std::string>& texts) {
  std::string file = "{\n \"witnesses\": [";
  std::size_t size = 100;
  for (const std::string& text : texts) size += text.size() + 4;
  file.reserve(size);
  for (const std::string& text : texts) (file += &text == &texts.front() ? "\n  " : ",\n  ") += text;
  return file += texts.empty() ? "]\n}\n" : "\n ]\n}\n";
}

void write_witnesses(const std::vector<FiledWitness>& witnesses, std::ostream& out) {
  std::vector<std::string> texts;
  for (const FiledWitness& witness : witnesses) texts.push_back(filed_text(witness));
  out << file_of(texts);
}

std::vector<FiledWitness> read_witnesses(std::istream& in) {
  try {
    std::vector<FiledWitness> made;
    const Json document = Json::parse(in);
    if (!document.is_object() || !document.contains("witnesses") || !document.at("witnesses").is_array())
      throw std::runtime_error("it is not {\"witnesses\": [...]}");
    for (const Json& each : document.at("witnesses")) {
      try {
        made.push_back(from_json(each));
      } catch (const std::exception& error) {
        throw std::runtime_error("witnesses[" + std::to_string(made.size()) + "]: " + plain(error));
      }
    }
    return made;
  } catch (const Json::exception& error) {
    throw std::runtime_error("not JSON: " + plain(error));
  }
}

std::string identity(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 1099511628211U;
  }
  static const char* const digits = "0123456789abcdef";
  std::string made;
  for (unsigned shift = 64; shift > 0; shift -= 4) made += digits[hash >> (shift - 4) & 15U];
  return made;
}

}  // namespace pal::analyzer::run_checker
