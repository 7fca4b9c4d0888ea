#include "analyzer/replay/witness_file.hpp"

#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace pal::analyzer::rules {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const FiledWitness& witness) {
  Json made;
  made["skill"] = witness.skill;
  made["environment"] = witness.environment;
  made["identity"] = witness.identity;
  for (const FiledSeat& seat : witness.placement)
    made["placement"].push_back(
        {{"thread", seat.thread}, {"processor", seat.processor}, {"priority", seat.priority}});
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

FiledWitness from_json(const Json& json) {
  FiledWitness made;
  made.skill = json.at("skill").get<std::string>();
  made.environment = json.at("environment").get<std::string>();
  made.identity = json.at("identity").get<std::string>();
  if (json.contains("placement")) {
    for (const Json& seat : json.at("placement")) {
      made.placement.push_back({seat.at("thread").get<std::string>(), seat.at("processor").get<int>(),
                                seat.at("priority").get<int>()});
      if (made.placement.back().processor < 0 || made.placement.back().processor >= 100)
        throw std::runtime_error("no witnesses: a processor of a placement is not between 0 and 99");
    }
  }
  made.requirement = json.at("requirement").get<std::string>();
  made.measure = json.at("measure").get<std::string>();
  made.failed = json.at("failed").get<bool>();
  made.grows = json.at("grows").get<bool>();
  made.value = json.at("value_ns").get<std::int64_t>();
  made.born = json.at("born_ns").get<std::int64_t>();
  made.at = json.at("at_ns").get<std::int64_t>();
  for (const Json& firing : json.at("script")) {
    made.script.push_back({firing.at("at_ns").get<std::int64_t>(), firing.at("timer").get<std::string>(),
                           firing.at("choices").get<std::vector<std::uint8_t>>()});
  }
  std::istringstream run(json.at("run").dump());
  made.run = trace::read_json(run);
  return made;
}

}  // namespace

void write_witnesses(const std::vector<FiledWitness>& witnesses, std::ostream& out) {
  Json document;
  document["witnesses"] = Json::array();
  for (const FiledWitness& witness : witnesses) document["witnesses"].push_back(to_json(witness));
  out << document.dump(1) << "\n";
}

std::vector<FiledWitness> read_witnesses(std::istream& in) {
  try {
    std::vector<FiledWitness> made;
    const Json document = Json::parse(in);
    for (const Json& each : document.at("witnesses")) made.push_back(from_json(each));
    return made;
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("no witnesses: ") + error.what());
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

}  // namespace pal::analyzer::rules
