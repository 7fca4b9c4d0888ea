#include "study/kept_proof.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <system_error>

#include "study/proof_key.hpp"

namespace pal::study {
namespace {

using analyzer::Addend;
using analyzer::Verdict;
using Measure = analyzer::Requirement::Measure;

constexpr std::string_view head = "pal-proof 1 ";
constexpr std::size_t digits = 64;

nlohmann::json json(const std::vector<Addend>& addends) {
  auto list = nlohmann::json::array();
  for (const Addend& each : addends)
    list.push_back({each.amount, each.actor, each.what, each.file, each.line, json(each.inside)});
  return list;
}

std::vector<Addend> addends(const nlohmann::json& list) {
  std::vector<Addend> made;
  for (const auto& each : list)
    made.push_back({each.at(0).get<analyzer::Nanoseconds>(), each.at(1).get<std::string>(),
                    each.at(2).get<std::string>(), each.at(3).get<std::string>(), each.at(4).get<int>(),
                    addends(each.at(5))});
  return made;
}

/// Fields of a line, each with a tabulator behind it.
class Writer {
 public:
  explicit Writer(std::string& out) : out_(out) {}
  Writer& add(std::string_view text) {
    out_.append(text).push_back('\t');
    return *this;
  }
  Writer& add(std::int64_t value) { return add(std::string_view(std::to_string(value))); }
  Writer& add(const std::optional<Duration>& value) {
    return value ? add(value->count()) : add(std::string_view("-"));
  }

 private:
  std::string& out_;
};

class Reader {
 public:
  explicit Reader(std::string_view line) : rest_(line) {}
  std::string_view text() {
    const auto end = rest_.find('\t');
    const std::string_view field = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    return field;
  }
  std::int64_t number() { return number_of(text()); }
  std::optional<Duration> duration() {
    const std::string_view field = text();
    return field == "-" ? std::nullopt : std::optional(Duration(number_of(field)));
  }

 private:
  static std::int64_t number_of(std::string_view field) {
    std::int64_t value = 0;
    std::from_chars(field.data(), field.data() + field.size(), value);
    return value;
  }
  std::string_view rest_;
};

std::optional<Duration> attained_in_run(const Verdict& verdict) {
  if (!verdict.witness || verdict.witness->failed) return std::nullopt;
  return Duration(verdict.witness->measured.value);
}

void write(const Verdict& verdict, bool with_addends, std::string& out) {
  Writer line(out);
  line.add(verdict.requirement)
      .add(static_cast<int>(verdict.measure))
      .add(static_cast<int>(verdict.state))
      .add(static_cast<int>(verdict.method))
      .add(verdict.limit.count())
      .add(verdict.at_least ? 1 : 0)
      .add(verdict.bound)
      .add(verdict.exact ? 1 : 0)
      .add(verdict.attained_load)
      .add(attained_in_run(verdict))
      .add(verdict.gave_up ? 1 : 0)
      .add(static_cast<std::int64_t>(verdict.taken_as_lost.size()));
  for (const analyzer::LostEvents& lost : verdict.taken_as_lost)
    line.add(static_cast<std::int64_t>(lost.device.index())).add(lost.lost).add(lost.in);
  line.add(with_addends ? json(verdict.addends).dump() : std::string());
  out.back() = '\n';
}

Verdict verdict_of(std::string_view text) {
  Reader line(text);
  Verdict verdict;
  verdict.requirement = line.text();
  verdict.measure = static_cast<Measure>(line.number());
  verdict.state = static_cast<Verdict::State>(line.number());
  verdict.method = static_cast<analyzer::Method>(line.number());
  verdict.limit = Duration(line.number());
  verdict.at_least = line.number() != 0;
  verdict.bound = line.duration();
  verdict.exact = line.number() != 0;
  verdict.attained_load = line.duration();
  if (const auto value = line.duration()) {
    verdict.witness.emplace();
    verdict.witness->measured.value = value->count();
  }
  verdict.gave_up = line.number() != 0;
  for (std::int64_t left = line.number(); left > 0; --left) {
    analyzer::LostEvents lost;
    lost.device = analyzer::DeviceId(static_cast<std::size_t>(line.number()));
    lost.lost = static_cast<int>(line.number());
    lost.in = static_cast<int>(line.number());
    verdict.taken_as_lost.push_back(lost);
  }
  if (const std::string_view own = line.text(); !own.empty())
    verdict.addends = addends(nlohmann::json::parse(own));
  return verdict;
}

std::string_view next_line(std::string_view& rest) {
  const auto end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return line;
}

}  // namespace

std::string file_text(const KeptProof& proof, const std::string& key) {
  std::string body = proof.addends_of + "\n" + proof.refused + "\n";
  for (const Verdict& verdict : proof.verdicts) write(verdict, !proof.addends_of.empty(), body);
  return std::string(head) + sha256(key + "\n" + body) + "\n" + body;
}

std::optional<KeptProof> kept_proof(std::string_view text, const std::string& key) {
  if (!text.starts_with(head) || text.size() < head.size() + digits + 1) return std::nullopt;
  const std::string_view checksum = text.substr(head.size(), digits);
  std::string_view body = text.substr(head.size() + digits + 1);
  if (text[head.size() + digits] != '\n' || sha256(key + "\n" + std::string(body)) != checksum)
    return std::nullopt;
  try {
    KeptProof proof;
    proof.addends_of = next_line(body);
    proof.refused = next_line(body);
    while (!body.empty()) proof.verdicts.push_back(verdict_of(next_line(body)));
    return proof;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // of a program that writes otherwise
  }
}

}  // namespace pal::study
