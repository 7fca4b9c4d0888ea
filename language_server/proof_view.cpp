// Proofs in place: hints, lenses, the list of requirements, pictures.
#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <utility>

#include "language_server/session.hpp"
#include "pal/pan/dot.hpp"

namespace pal::language_server {

namespace {

/// Light lines on a dark ground, in the same hues; the paper of a PAN becomes transparent.
std::string in_dark(std::string svg) {
  constexpr std::string_view paper = "<polygon fill=\"white\"";
  if (const auto at = svg.find(paper); at != std::string::npos)
    svg.replace(at, paper.size(), "<polygon fill=\"transparent\"");
  const auto open = svg.find("<svg");
  if (open != std::string::npos) svg.insert(open + 4, " style=\"filter:invert(.94) hue-rotate(180deg)\"");
  return svg;
}

/// The groups of nodes in a picture by Graphviz: `<g id="node3" class="node">`, then `<title>12 WTM( …
/// )</title>`.
std::vector<Drawing::Place> places_of(const std::string& svg, const pan::Graph& body) {
  std::vector<Drawing::Place> places;
  constexpr std::string_view group = "<g id=\"node";
  for (auto at = svg.find(group); at != std::string::npos; at = svg.find(group, at + 1)) {
    const auto begin = at + 7;
    const auto end = svg.find('"', begin);
    const auto title = svg.find("<title>", at);
    if (end == std::string::npos || title == std::string::npos) break;
    std::size_t node = 0;
    const char* first = svg.data() + title + 7;
    if (std::from_chars(first, svg.data() + svg.size(), node).ec != std::errc{} || node >= body.nodes.size())
      continue;
    if (body.nodes[node].where.valid())
      places.push_back({svg.substr(begin, end - begin), body.nodes[node].where});
  }
  return places;
}

Json picture_json(const Drawing& drawing, const Analysis& analysis, const Workspace& workspace) {
  Json places = Json::array();
  for (const auto& place : drawing.places)
    places.push_back(
        {{"id", place.id},
         {"uri", workspace.uri(analysis.path(place.where.file))},
         {"range", range_of(analysis.text(place.where.file), place.where.begin, place.where.end)}});
  return places;
}

Json empty_picture(const Json& params) {
  return {
      {"svg", ""},
      {"reason", ""},
      {"title", ""},
      {"kind", string_of(params, "kind")},
      {"skill", ""},
      {"module", ""},
      {"requirement", ""},
      {"environment", ""},
      {"state", ""},
      {"stale", false},
      {"places", Json::array()},
      {"choices", {{"skills", Json::array()}, {"modules", Json::array()}, {"requirements", Json::array()}}}};
}

/// Whether a place is in [begin, end] of a span.
bool holds(const SourceSpan& where, FileId file, std::uint32_t offset) {
  return where.file == file && where.begin <= offset && offset <= where.end;
}

struct Proved {
  const SkillProof* proof = nullptr;
  const ProvedRequirement* of = nullptr;  // nullptr: it is not among them
};

Proved proved_in(const Proofs* proofs, const std::string& skill, const std::string& requirement) {
  for (std::size_t i = 0; proofs != nullptr && i < proofs->size(); ++i) {
    const SkillProof& proof = (*proofs)[i];
    for (const auto& each : proof.requirements) {
      if (proof.skill == skill && each.name == requirement) return {&proof, &each};
    }
  }
  return {};
}

const char* remark(const SkillProof& proof, const ProvedRequirement& requirement) {
  if (requirement.state == "fails") return ", fails";
  if (requirement.state == "open") return ", not decided yet";
  return proof.ended && requirement.state == "undecided" ? ", not decided in time" : "";
}

}  // namespace

Json Session::inlay_hint(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  Json all = Json::array();
  if (!hints_ || text == nullptr) return all;
  const auto from = position_of(member(member(params, "range"), "start"));
  const auto to = position_of(member(member(params, "range"), "end"));
  for (const auto& root : roots_of(path)) {
    const auto known = known_.find(root);
    if (known == known_.end()) continue;
    if (root == path) add_bounds(known->second, path, *text, all);
    if (known->second.proofs == nullptr || known->second.proved != known->second.analysis)
      continue;  // its places are those of an earlier text
    add_slacks(known->second, path, all);
    add_shares(known->second, path, all);
  }
  Json result = Json::array();
  for (auto& hint : all) {
    const auto at = position_of(hint["position"]);
    if (at < from || to < at || std::find(result.begin(), result.end(), hint) != result.end()) continue;
    result.push_back(std::move(hint));
  }
  return result;
}

void Session::add_bounds(const Known& known, const std::string& path, const Text& text, Json& hints) {
  const auto* tree = index_.tree(path);
  for (std::size_t i = 0; tree != nullptr && i < tree->units.size(); ++i) {
    const auto* skill = std::get_if<syntax::SkillUnit>(&tree->units[i]);
    if (skill == nullptr) continue;
    for (const auto& requirement : skill->requirements) {
      // Of an earlier text: what it said till the new proof says something.
      const auto now = proved_in(known.current(), skill->name.text, requirement.name.text);
      const bool says = now.of != nullptr && (now.of->state != "open" || !now.of->bound.empty());
      const auto shown = says ? now : proved_in(known.proofs.get(), skill->name.text, requirement.name.text);
      if (shown.of == nullptr) continue;
      const auto& each = *shown.of;
      hints.push_back({{"position", json_of(text.position(requirement.where.end))},
                       {"label", (says ? "" : "(was) ") + each.bound + " of " + each.limit +
                                     (each.exact ? ", exact" : "") + remark(*shown.proof, each)},
                       {"paddingLeft", true},
                       {"tooltip", each.measure + " in " + shown.proof->environment + ": " + each.state}});
    }
  }
}

void Session::add_slacks(const Known& known, const std::string& path, Json& hints) const {
  const auto file = known.analysis->file(path);
  if (!file || known.advice == nullptr) return;
  const Text& text = known.analysis->text(*file);
  for (const auto& advice : *known.advice) {
    for (const auto& slack : advice.slacks) {
      if (slack.where.file != *file) continue;
      hints.push_back({{"position", json_of(text.position(slack.where.end))},
                       {"label", "slack " + slack.amount},
                       {"paddingLeft", true},
                       {"tooltip", advice.skill + ": " + slack.explanation}});
    }
  }
}

/// The shares of the requirement that fails, or else comes nearest to it: the first with a worst run.
void Session::add_shares(const Known& known, const std::string& path, Json& hints) const {
  const auto file = known.analysis->file(path);
  if (!file) return;
  const Text& text = known.analysis->text(*file);
  for (const auto& proof : *known.proofs) {
    const ProvedRequirement* shown = nullptr;
    for (const auto& each : proof.requirements) {
      if (each.shares.empty()) continue;
      if (shown == nullptr || (each.state == "fails" && shown->state != "fails")) shown = &each;
    }
    if (shown == nullptr) continue;
    std::map<std::uint32_t, std::pair<std::string, std::string>> at;  // by end of the statement
    for (const auto& share : shown->shares) {
      if (share.where.file != *file) continue;
      auto& [label, tooltip] = at[share.where.end];
      label += (label.empty() ? "" : " + ") + share.amount;
      tooltip += (tooltip.empty() ? "" : "\n") + share.amount + ": " + share.what;
    }
    for (const auto& [end, words] : at)
      hints.push_back(
          {{"position", json_of(text.position(end))},
           {"label", words.first + " of " + shown->name},
           {"paddingLeft", true},
           {"tooltip", "worst run of " + shown->name + " of " + proof.skill + "\n" + words.second}});
  }
}

Json Session::code_lens(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  const auto* tree = index_.tree(path);
  Json result = Json::array();
  if (text == nullptr || tree == nullptr) return result;
  const auto lens = [&](const SourceSpan& where, const char* title, const char* command, Json arguments) {
    if (commands_.contains(command))
      result.push_back(
          {{"range", range_of(*text, where.begin, where.end)},
           {"command", {{"title", title}, {"command", command}, {"arguments", {std::move(arguments)}}}}});
  };
  const auto roots = roots_of(path);
  const auto known = known_.find(roots.front());
  const std::string uri = workspace_.uri(path);
  std::string first_skill;
  if (known != known_.end() && known->second.analysis != nullptr &&
      !known->second.analysis->specification.skills.empty())
    first_skill = known->second.analysis->specification.skills.front().skill.name;
  for (const auto& unit : tree->units) {
    if (const auto* module = std::get_if<syntax::ModuleUnit>(&unit); module != nullptr && module->has_body) {
      lens(module->where, "graph", "pal.showGraph",
           {{"uri", uri}, {"skill", first_skill}, {"module", module->name.text}});
    }
    const auto* skill = std::get_if<syntax::SkillUnit>(&unit);
    if (skill == nullptr) continue;
    std::string environment;
    const Proofs* proofs = known == known_.end() ? nullptr : known->second.proofs.get();
    if (known != known_.end() && known->second.sound != nullptr) {
      const auto& sound = *known->second.sound;
      for (std::size_t i = 0; i < sound.specification.skills.size(); ++i) {
        const auto* chosen = sound.environment(i);
        if (chosen != nullptr && sound.specification.skills[i].skill.name == skill->name.text)
          environment = workspace_.uri(sound.path(chosen->where.file));
      }
    }
    lens(skill->name.where, "what if", "pal.whatIf",
         {{"uri", uri}, {"skill", skill->name.text}, {"environmentUri", environment}});
    lens(skill->name.where, "run in the workcell", "pal.runInWorkcell",
         {{"uri", uri}, {"skill", skill->name.text}});
    for (std::size_t i = 0; proofs != nullptr && i < proofs->size(); ++i) {
      for (const auto& each : (*proofs)[i].requirements) {
        const auto found = std::find_if(skill->requirements.begin(), skill->requirements.end(),
                                        [&](const auto& written) { return written.name.text == each.name; });
        if ((*proofs)[i].skill == skill->name.text && each.has_run && found != skill->requirements.end())
          lens(found->name.where, "chart", "pal.showChart",
               {{"uri", uri}, {"skill", skill->name.text}, {"requirement", each.name}});
      }
    }
  }
  return result;
}

Json Session::requirements(const Json& params) {
  Json result = Json::array();
  for (const auto& root : roots_of(path_in(params))) {
    const Known& here = known(root);
    const auto analysis = here.analysis;
    for (std::size_t i = 0; i < analysis->specification.skills.size(); ++i) {
      const auto& network = analysis->specification.skills[i];
      const auto& where = network.skill.where;
      const auto* environment = analysis->environment(i);
      Json list = Json::array();
      for (const auto& requirement : network.requirements) {
        Json made{{"name", requirement.name},
                  {"uri", workspace_.uri(analysis->path(requirement.where.file))},
                  {"range", range_of(analysis->text(requirement.where.file), requirement.where.begin,
                                     requirement.where.end)},
                  {"state", "open"},
                  {"bound", ""},
                  {"limit", ""},
                  {"exact", false},
                  {"message", ""}};
        const auto found = proved_in(here.current(), network.skill.name, requirement.name);
        if (found.of != nullptr) {
          std::string message;
          for (const auto& finding : found.of->findings)
            message += (message.empty() ? "" : "\n") + finding.message;
          made["state"] = found.of->state;
          made["bound"] = found.of->bound;
          made["limit"] = found.of->limit;
          made["exact"] = found.of->exact;
          made["message"] = message;
        }
        list.push_back(std::move(made));
      }
      result.push_back(
          {{"skill", network.skill.name},
           {"uri", workspace_.uri(analysis->path(where.file))},
           {"range", range_of(analysis->text(where.file), where.begin, where.end)},
           {"environment", environment == nullptr ? "" : environment->name},
           {"environmentUri",
            environment == nullptr ? std::string() : workspace_.uri(analysis->path(environment->where.file))},
           {"requirements", std::move(list)}});
    }
  }
  return result;
}

Json Session::picture(const Json& params) {
  const std::string kind = string_of(params, "kind");
  if (kind == "pan") return pan_picture(params);
  if (kind == "atc") return atc_picture(params);
  throw Refusal{invalid_params, "kind must be pan or atc"};
}

Json Session::pan_picture(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  Json result = empty_picture(params);
  const std::string wanted_skill = string_of(params, "skill");
  const std::string wanted_module = string_of(params, "module");
  const bool has_position = !member(params, "position").is_null() && text != nullptr;
  const auto offset = has_position ? text->offset(position_of(member(params, "position"))) : 0;
  const pan::Network* network = nullptr;
  std::shared_ptr<const Analysis> analysis;
  for (const auto& root : roots_of(path)) {
    const Known& here = known(root);
    const auto source =
        here.analysis->diagnostics.has_errors() && here.sound != nullptr ? here.sound : here.analysis;
    for (const auto* list : {&source->specification.skills, &source->specification.sketches}) {
      for (const auto& each : *list) {
        result["choices"]["skills"].push_back(each.skill.name);
        if (network != nullptr || (!wanted_skill.empty() && each.skill.name != wanted_skill)) continue;
        network = &each;
        analysis = source;
        result["stale"] = source != here.analysis;
      }
    }
  }
  if (network == nullptr) {
    result["reason"] = "there is no skill without errors in this file, and no module by itself";
    return result;
  }
  std::optional<std::size_t> chosen;
  const auto file = analysis->file(path);
  for (std::size_t i = 0; i < network->modules.size(); ++i) {
    const auto& module = network->modules[i];
    if (module.body.empty()) continue;
    result["choices"]["modules"].push_back(module.name);
    const auto& nodes = module.body.nodes;
    const bool here = has_position && file && nodes.front().where.file == *file &&
                      nodes.front().where.begin <= offset && offset <= nodes.back().where.end;
    if (!wanted_module.empty() ? module.name == wanted_module : here) chosen = i;
  }
  if (!chosen && wanted_module.empty()) {
    for (std::size_t i = 0; i < network->modules.size() && !chosen; ++i) {
      if (!network->modules[i].body.empty() && (!network->main.valid() || network->main.index() == i))
        chosen = i;
    }
  }
  if (!chosen) {
    result["reason"] = wanted_module.empty() ? "no module has a body"
                                             : "there is no module '" + wanted_module + "' with a body";
    return result;
  }
  pan::DotOptions options;
  options.letters = flag_of(params, "letters");
  if (options.letters) options.direction = pan::DotOptions::Direction::left_to_right;
  Drawing drawing{pan::svg(pan::to_dot(*network, pan::ModuleId(*chosen), options)), {}};
  drawing.places = places_of(drawing.svg, network->modules[*chosen].body);
  result["skill"] = network->skill.name;
  result["module"] = network->modules[*chosen].name;
  result["title"] = network->modules[*chosen].name + " of " + network->skill.name;
  result["places"] = picture_json(drawing, *analysis, workspace_);
  result["svg"] = flag_of(params, "dark") ? in_dark(std::move(drawing.svg)) : std::move(drawing.svg);
  return result;
}

Json Session::atc_picture(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  Json result = empty_picture(params);
  result["reason"] = "nothing is proved yet: there are errors, no environment, or no requirement";
  const std::string wanted_skill = string_of(params, "skill");
  const std::string wanted = string_of(params, "requirement");
  const bool has_position = !member(params, "position").is_null() && text != nullptr;
  const auto offset = has_position ? text->offset(position_of(member(params, "position"))) : 0;
  for (const auto& root : roots_of(path)) {
    const Known& here = known(root);
    if (here.proofs == nullptr) continue;
    for (const auto& proof : *here.proofs) {
      result["choices"]["skills"].push_back(proof.skill);
      if (!wanted_skill.empty() && proof.skill != wanted_skill) continue;
      const auto file = here.proved == nullptr ? std::nullopt : here.proved->file(path);
      std::optional<std::size_t> chosen, failing, any;
      for (std::size_t i = 0; i < proof.requirements.size(); ++i) {
        const auto& each = proof.requirements[i];
        if (each.has_run || each.state == "undecided") result["choices"]["requirements"].push_back(each.name);
        if (!each.has_run) continue;
        const bool at = has_position && file && !each.findings.empty() &&
                        holds(each.findings.front().where, *file, offset);
        if (!wanted.empty() ? each.name == wanted : at) chosen = i;
        if (each.state == "fails" && !failing) failing = i;
        if (!any) any = i;
      }
      if (!chosen && wanted.empty()) chosen = failing ? failing : any;
      if (!result["svg"].get<std::string>().empty() || !chosen) continue;
      const auto& each = proof.requirements[*chosen];
      auto drawing = proof.chart(*chosen, flag_of(params, "narrow"));
      if (!drawing) continue;
      result["reason"] = "";
      result["skill"] = proof.skill;
      result["requirement"] = each.name;
      result["environment"] = proof.environment;
      result["state"] = each.state;
      result["stale"] = here.proved != here.analysis;
      result["title"] = each.name + " of " + proof.skill + " in " + proof.environment;
      result["places"] = picture_json(*drawing, *here.proved, workspace_);
      result["svg"] = flag_of(params, "dark") ? in_dark(std::move(drawing->svg)) : std::move(drawing->svg);
    }
  }
  if (result["svg"].get<std::string>().empty() && !wanted.empty())
    result["reason"] = "'" + wanted + "' has no worst run to draw";
  return result;
}

}  // namespace pal::language_server
