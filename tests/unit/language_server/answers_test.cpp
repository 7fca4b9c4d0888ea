// What an editor asks beside findings: signatures, the flow of messages, selections, advice, operations; and
// an analyst's mistake of each family, mended by quick fixes alone.
#include "tests/unit/language_server/client.hpp"

using namespace pal;
using namespace pal::language_server;
using namespace pal::language_server::test;

namespace {

const Json all{{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 999}, {"character", 0}}}};
const Json long_proofs{{"proofTimeSeconds", 60}};

using Texts = std::map<std::string, std::string>;

/// The texts after the first quick fix whose title holds `title`, wherever it is offered.
Texts after_fix(const Texts& texts, const std::string& title, const Json& settings = long_proofs) {
  std::map<std::string, std::string> files;
  for (const auto& [name, text] : texts) files["/w/" + name] = text;
  Client client(settings, files);
  std::vector<int> asked;
  for (const auto& [name, text] : texts) client.open(name, text);
  for (const auto& [name, text] : texts)
    asked.push_back(client.ask("textDocument/codeAction", {{"textDocument", {{"uri", uri(name)}}},
                                                           {"range", all},
                                                           {"context", {{"diagnostics", Json::array()}}}}));
  client.run();
  std::string titles;
  for (const int id : asked) {
    for (const auto& action : client.result(id)) {
      titles += action["title"].get<std::string>() + "\n";
      if (action["title"].get<std::string>().find(title) == std::string::npos) continue;
      Texts result = texts;
      for (const auto& [at, edits] : action["edit"]["changes"].items()) {
        auto& text = result.at(at.substr(uri("").size()));
        text = applied(text, edits);
      }
      return result;
    }
  }
  FAIL("no quick fix with '" + title + "' among\n" + titles);
  return {};
}

std::set<std::string> codes(const Texts& texts, const Json& settings = long_proofs) {
  std::map<std::string, std::string> files;
  for (const auto& [name, text] : texts) files["/w/" + name] = text;
  Client client(settings, files);
  for (const auto& [name, text] : texts) client.open(name, text);
  client.run();
  std::set<std::string> result;
  for (const auto& [name, text] : texts)
    for (const auto& finding : client.findings(name)) result.insert(finding["code"].get<std::string>());
  return result;
}

const Texts good{{"shared.pal", shared}, {"feel.pal", skill}, {"cell.pal", cell}};

Texts with(const std::string& file, const std::string& from, const std::string& to) {
  Texts texts = good;
  texts[file] = replaced(texts[file], from, to);
  return texts;
}

const Texts overload{{"turn.pal", R"(USES "parts.pal"

SKILL turn
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 2 ERROR  "any fault"

  REQUIREMENT headroom : LOAD OF EACH PROCESSOR AT MOST 90 %
END SKILL

Skill Module: SM1
  ACTIVITY plan WRITES step
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( request step from MC1 )
    plan
    TXM( step to MC1 )
  UNTIL( forever )
END
)"},
                     {"parts.pal", R"(MESSAGE tick : SIGNAL
MESSAGE step : REAL mm
DEVICE axis "moves"

Machine Controller: MC1
  ACTIVITY servo READS step
BEGIN
  REPEAT
    WTM( tick from axis )
    TXM( request step from SM1 )
    WTM( step from SM1 )
    servo
    TXM( step to axis )
  UNTIL( forever )
END
)"},
                     {"bench.pal", R"(ENVIRONMENT two
  PROCESSOR P0
  PROCESSOR P1
  DEVICE axis EVENT tick EVERY 20 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE MC1 ON P0 PRIORITY 2
  TIME plan OF SM1  : 10 ms
  TIME servo OF MC1 : 9 ms
END ENVIRONMENT
)"}};

}  // namespace

TEST_CASE("a mistake of each family is mended by a quick fix") {
  struct Mistake {
    const char* family;
    Texts texts;
    const char* code;
    const char* title;
  };
  Texts lost = good;  // what LS1 sends more than it is asked for is taken by nobody
  lost["shared.pal"] =
      replaced(shared, "    TXM( force to SM1 )\n", "    TXM( force to SM1 )\n    TXM( spare to SM1 )\n");
  lost["shared.pal"] = "MESSAGE spare : SIGNAL\n" + lost["shared.pal"];
  Texts deadlock = good;
  deadlock["feel.pal"] = replaced(skill, "  look\n", "  WTM( force from LS1 )\n  look\n");
  const std::vector<Mistake> mistakes{
      {"name", with("feel.pal", "WTM( force from LS1 )", "WTM( forse from LS1 )"), "PAL0202", "by 'force'"},
      {"kind", with("feel.pal", "WTM( force from LS1 )", "WTM( force from sensor driver LS1 )"), "PAL0206",
       "by 'logical sensor LS1'"},
      {"layer", with("feel.pal", "TXM( request force from LS1 )", "TXM( request force from SD1 )"), "PAL0301",
       "by 'LS1'"},
      {"message that is not sent", with("feel.pal", "  TXM( request force from LS1 )\n", ""), "PAL0302",
       "insert TXM( request force from LS1 )"},
      {"deadlock", deadlock, "PAL0521", "insert TXM( request force from LS1 )"},
      {"lost message", lost, "PAL0303", "insert WTM( spare from LS1 ) before look"},
      {"late answer", with("feel.pal", "AT MOST 20 ms", "AT MOST 4 ms"), "PAL0890", "for look OF SM1"},
  };
  for (const auto& [family, texts, code, title] : mistakes) {
    INFO(family);
    CHECK(codes(texts).contains(code));
    CHECK(codes(after_fix(texts, title)).empty());
  }
}

TEST_CASE("an overload is mended by another place") {
  const Json short_proofs{{"proofTimeSeconds", 1}};              // each look at three opened texts
  const std::set<std::string> never_ends{"PAL0512", "PAL0612"};  // as it is meant
  auto overloaded = never_ends;
  overloaded.insert("PAL0890");
  CHECK(codes(overload, short_proofs) == overloaded);
  CHECK(codes(after_fix(overload, "place SM1 on P1", short_proofs), short_proofs) == never_ends);
}

TEST_CASE("a finding in a file that is not open is told") {
  Client client;
  client.open("feel.pal", replaced(skill, "  TXM( request force from LS1 )\n", ""));
  client.run();
  REQUIRE(client.findings("shared.pal").size() == 1);
  CHECK(client.findings("shared.pal")[0]["code"] == "PAL0302");
}

TEST_CASE("slack stands beside times, shares beside statements") {
  Client client(long_proofs);
  client.open("feel.pal", skill);
  client.open("cell.pal", cell);
  const auto hints = [&](const char* file) {
    return client.ask("textDocument/inlayHint", {{"textDocument", {{"uri", uri(file)}}}, {"range", all}});
  };
  const int of_cell = hints("cell.pal");
  const int of_skill = hints("feel.pal");
  client.run();
  std::map<int, std::string> at;
  for (const auto& hint : client.result(of_cell)) at[hint["position"]["line"]] = hint["label"];
  CHECK(at[6] == "slack 15 ms");  // TIME look: 5 ms of 20 ms
  CHECK(at[2] == "slack 15 ms");  // DEVICE cell
  at.clear();
  for (const auto& hint : client.result(of_skill)) at[hint["position"]["line"]] = hint["label"];
  CHECK(at[9] == "5 ms of 20 ms, exact");
  CHECK(at[18] == "3 ms of soon");  // look
}

namespace {

/// A requirement that a look for verdicts alone decides by a bound which no run is known to attain.
class OneBound : public Prover {
 public:
  SkillProof prove(const pan::Network& network, const pan::Environment& environment, const SourceManager&,
                   Depth depth, double, const std::function<bool()>&,
                   const std::function<void(SkillProof)>& told) const override {
    SkillProof proof{network.skill.name, environment.name, {}, {}, false, {}};
    ProvedRequirement& made = proof.requirements.emplace_back();
    made.name = "soon";
    made.state = "open";
    made.bound = "<= 9 ms";
    made.limit = "20 ms";
    proof.chart = [](std::size_t, bool) { return std::nullopt; };
    if (told) told(proof);
    proof.requirements.front().state = "holds";
    proof.requirements.front().exact = depth == Depth::whole;
    return proof;
  }
  Advice advise(const pan::Network& network, const pan::Environment&, const SourceManager&, double,
                const std::function<bool()>&) const override {
    return {network.skill.name, {}, {}};
  }
};

/// The kinds of progress of one token, in their order, with what else was sent in between.
std::vector<std::string> story(const std::vector<Json>& sent) {
  std::vector<std::string> told;
  std::string token;
  for (const auto& message : sent) {
    const auto method = message.value("method", "");
    if (method == "window/workDoneProgress/create") {
      token = message["params"]["token"];
      told.emplace_back("create");
    } else if (method == "$/progress") {
      CHECK(message["params"]["token"] == token);
      told.push_back(message["params"]["value"]["kind"]);
    } else if (method == "pal/changed" && message["params"]["what"] == "proof") {
      told.emplace_back("proof");
    }
  }
  return told;
}

}  // namespace

TEST_CASE("a long proof is told: first bounds, verdicts, then progress until the worst runs are known") {
  const OneBound prover;
  Client client(Json{{"pictures", true}});
  client.open("feel.pal", skill);
  client.run(prover);
  CHECK(story(client.sent) == std::vector<std::string>{"proof", "proof", "create", "begin", "proof", "end"});
  for (const auto& message : client.sent) {
    if (message.value("method", "") == "$/progress" && message["params"]["value"]["kind"] == "begin")
      CHECK(message["params"]["value"]["message"] == "feel");
  }
}

TEST_CASE("an edit of other words leaves proofs as they are, with the lines of the new text") {
  const auto charted = [](const std::string& text, bool edited) {
    Client client(long_proofs);
    client.open("feel.pal", edited ? skill : text);
    if (edited)
      client.tell("textDocument/didChange", {{"textDocument", {{"uri", uri("feel.pal")}, {"version", 2}}},
                                             {"contentChanges", {{{"text", text}}}}});
    const int asked = client.ask("pal/requirements", {{"textDocument", {{"uri", uri("feel.pal")}}}});
    const int drawn =
        client.ask("pal/picture", {{"textDocument", {{"uri", uri("feel.pal")}}}, {"kind", "atc"}});
    client.run(program::EditorProver());
    return std::pair(client.result(asked), client.result(drawn));
  };
  const std::string moved = "# a line more\n" + replaced(skill, "  look\n", "  # and one here\n\n  look\n");
  CHECK(charted(moved, true) == charted(moved, false));
  const std::string stricter = replaced(skill, "AT MOST 20 ms", "AT MOST 4 ms");
  const auto edited = charted(stricter, true);
  CHECK(edited.first[0]["requirements"][0]["state"] == "fails");
  CHECK(edited == charted(stricter, false));
  const std::string later = replaced(skill, "  look\n", "  look\n  look\n");
  CHECK(charted(later, true) == charted(later, false));
  CHECK(charted(later, true).first != charted(skill, false).first);
}

TEST_CASE("a requirement that fails is told once more at the statement to change") {
  Client client(long_proofs);
  client.open("feel.pal", replaced(skill, "AT MOST 20 ms", "AT MOST 4 ms"));
  client.ask("pal/requirements", {{"textDocument", {{"uri", uri("feel.pal")}}}});
  client.run(program::EditorProver());
  const Json findings = client.findings("feel.pal");
  const bool told = std::any_of(findings.begin(), findings.end(), [](const Json& each) {
    const Json related = each.value("relatedInformation", Json::array());
    return !related.empty() && related[0]["message"] == "'soon' is required here";
  });
  INFO(findings.dump(1));
  CHECK(told);
}

TEST_CASE("the signature of a message") {
  Client client;
  client.open("feel.pal", skill);
  const int message = client.ask_at("textDocument/signatureHelp", "feel.pal", " request force from");
  const int module = client.ask_at("textDocument/signatureHelp", "feel.pal", "LS1 )\n  look");
  const int nowhere = client.ask_at("textDocument/signatureHelp", "feel.pal", "look\n");
  client.run();
  CHECK(client.result(message)["signatures"][0]["label"] == "TXM( message to module )");
  CHECK(client.result(message)["activeParameter"] == 0);
  const Json& known = client.result(module);
  CHECK(known["signatures"][0]["label"] == "WTM( force from module )");
  CHECK(known["activeParameter"] == 1);
  CHECK(known["signatures"][0]["documentation"]["value"].get<std::string>().find("- Content: real, in N") !=
        std::string::npos);
  CHECK(client.result(nowhere).is_null());
}

TEST_CASE("who sends and who takes, as a hierarchy") {
  Client client;
  client.open("feel.pal", skill);
  client.open("shared.pal", shared);
  const int prepared = client.ask_at("textDocument/prepareCallHierarchy", "feel.pal", "LS1 )");
  const int message = client.ask_at("textDocument/prepareCallHierarchy", "feel.pal", "force from LS1", 1);
  const Json item{{"data", {{"root", "/w/feel.pal"}, {"kind", "module"}, {"name", "LS1"}}}};
  const Json force{{"data", {{"root", "/w/feel.pal"}, {"kind", "message"}, {"name", "force"}}}};
  const Json driver{{"data", {{"root", "/w/feel.pal"}, {"kind", "module"}, {"name", "SD1"}}}};
  const int incoming = client.ask("callHierarchy/incomingCalls", {{"item", item}});
  const int outgoing = client.ask("callHierarchy/outgoingCalls", {{"item", item}});
  const int senders = client.ask("callHierarchy/incomingCalls", {{"item", force}});
  const int takers = client.ask("callHierarchy/outgoingCalls", {{"item", force}});
  const int into_driver = client.ask("callHierarchy/incomingCalls", {{"item", driver}});
  client.run();
  const auto names = [&](int id, const char* end) {
    std::set<std::string> result;
    for (const auto& call : client.result(id)) {
      result.insert(call[end]["name"].get<std::string>());
      CHECK_FALSE(call["fromRanges"].empty());
    }
    return result;
  };
  REQUIRE(client.result(prepared).size() == 1);
  CHECK(client.result(prepared)[0]["name"] == "LS1");
  CHECK(client.result(prepared)[0]["uri"] == uri("shared.pal"));
  CHECK(client.result(message)[0]["data"]["kind"] == "message");
  CHECK(names(incoming, "from") == std::set<std::string>{"SD1", "SM1"});
  CHECK(names(outgoing, "to") == std::set<std::string>{"SD1", "SM1"});
  CHECK(names(senders, "from") == std::set<std::string>{"LS1", "SD1", "cell"});
  CHECK(names(takers, "to") == std::set<std::string>{"LS1", "SD1", "SM1"});
  CHECK(names(into_driver, "from") == std::set<std::string>{"LS1", "cell"});
}

TEST_CASE("a selection grows from the word to the file") {
  Client client;
  client.open("feel.pal", skill);
  const auto at = Text(skill).position(skill.find("Protocol 0 )\n    ( pressed = FALSE"));
  const int id = client.ask("textDocument/selectionRange",
                            {{"textDocument", {{"uri", uri("feel.pal")}}},
                             {"positions", {{{"line", at.line}, {"character", at.character}}}}});
  client.run();
  std::vector<std::string> texts;
  const Text text(skill);
  const auto place = [&](const Json& position) {
    return text.offset({position["line"], position["character"]});
  };
  const Json* range = &client.result(id)[0];
  for (;;) {
    const auto begin = place((*range)["range"]["start"]), end = place((*range)["range"]["end"]);
    texts.push_back(skill.substr(begin, end - begin));
    if (!range->contains("parent")) break;
    range = &(*range)["parent"];
  }
  REQUIRE(texts.size() > 5);
  CHECK(texts[0] == "Protocol");
  CHECK(texts[1] == "TXM( Completion Protocol 0 )");
  CHECK(texts[texts.size() - 2].starts_with("Skill Module: SM1"));
  CHECK(texts.back() == skill);
  for (std::size_t i = 1; i < texts.size(); ++i) CHECK(texts[i].find(texts[i - 1]) != std::string::npos);
}

TEST_CASE("the END of a block is written with it, once") {
  const auto typed = [](const std::string& before, const std::string& line, const std::string& after) {
    const std::string text = before + line + "\n    \n" + after;
    Client client;
    client.open("feel.pal", text);
    const auto at = Text(text).position((before + line + "\n    ").size());
    const int id = client.ask("textDocument/onTypeFormatting",
                              {{"textDocument", {{"uri", uri("feel.pal")}}},
                               {"position", {{"line", at.line}, {"character", at.character}}},
                               {"ch", "\n"},
                               {"options", Json::object()}});
    client.run();
    const Json& edits = client.result(id);
    return edits.empty() ? std::string("nothing") : edits[0]["newText"].get<std::string>();
  };
  const std::string head = "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n";
  CHECK(typed(head, "  CASE", "END\n") == "  END CASE\n");
  CHECK(typed(head, "  REPEAT", "END\n") == "  UNTIL( forever )\n");
  CHECK(typed(head, "  REPEAT", "  UNTIL( forever )\nEND\n") == "nothing");
  CHECK(typed(head, "  CONCURRENT", "END\nSkill Module: SM2\nBEGIN\nEND\n") == "  END CONCURRENT\n");
  CHECK(typed("Skill Module: SM1\n", "BEGIN", "") == "END\n");
  CHECK(typed(head, "  look", "END\n") == "nothing");
}

TEST_CASE("a file of operations has findings, words and help") {
  const std::string operation = R"({
  "operation-format": 1,
  "name": "try",
  "icons": [
    {"id": "start", "kind": "start", "next": "feel"},
    {"id": "feel", "kind": "skill", "skill": "feel", "parameters": {"depht": 5}, "next": "done", "error": "done"},
    {"id": "done", "kind": "exit"}
  ]
}
)";
  const std::string with_parameter =
      replaced(skill, "  COMPLETION 0",
               "  PARAMETER depth : REAL mm DEFAULT 5 RANGE 1 TO 40 \"how deep\"\n  COMPLETION 0");
  Client client(long_proofs,
                {{"/w/shared.pal", shared}, {"/w/feel.pal", with_parameter}, {"/w/cell.pal", cell}});
  client.open("try.op.json", operation);
  const int fix = client.ask("textDocument/codeAction", {{"textDocument", {{"uri", uri("try.op.json")}}},
                                                         {"range", all},
                                                         {"context", {{"diagnostics", Json::array()}}}});
  const int skills = client.ask_at("textDocument/completion", "try.op.json", "feel\", \"parameters");
  const int names = client.ask_at("textDocument/completion", "try.op.json", "epht");
  const int icons = client.ask_at("textDocument/completion", "try.op.json", "one\", \"error");
  const int hover = client.ask_at("textDocument/hover", "try.op.json", "eel\", \"parameters");
  const int symbols =
      client.ask("textDocument/documentSymbol", {{"textDocument", {{"uri", uri("try.op.json")}}}});
  const int fields = client.ask_at("textDocument/completion", "try.op.json", "ext\": \"done\"");
  const int outer = client.ask_at("textDocument/completion", "try.op.json", "ame\": \"try");
  const int field = client.ask_at("textDocument/hover", "try.op.json", "rror\": \"done");
  const int of_file = client.ask_at("textDocument/hover", "try.op.json", "cons\"");
  client.open("try.op.json", replaced(operation, "depht", "depth"));
  const int value = client.ask_at("textDocument/completion", "try.op.json", "5}");
  const int parameter = client.ask_at("textDocument/hover", "try.op.json", "epth");
  client.run();
  CHECK(labels(client.result(skills)) == std::set<std::string>{"feel"});
  CHECK(labels(client.result(names)) == std::set<std::string>{"depth"});
  CHECK(client.result(names)[0]["detail"].get<std::string>().find("from 1 to 40 mm") != std::string::npos);
  CHECK(labels(client.result(icons)) == std::set<std::string>{"done", "feel", "start"});
  CHECK(client.result(hover)["contents"]["value"].get<std::string>().find("code 0, normal: done") !=
        std::string::npos);
  CHECK(client.result(parameter)["contents"]["value"].get<std::string>().find("how deep") !=
        std::string::npos);
  CHECK(labels(client.result(value)) == std::set<std::string>{"5"});
  CHECK(client.result(symbols).is_null());
  // Of a skill's icon, not of a delay's or an operation's.
  CHECK(labels(client.result(fields)).contains("time-limit"));
  CHECK_FALSE(labels(client.result(fields)).contains("seconds"));
  CHECK(labels(client.result(outer)).contains("on-stop"));
  CHECK(client.result(field)["contents"]["value"] ==
        "`error`: a text\n\nThe icon that comes if it does not end normally.");
  CHECK(client.result(of_file)["contents"]["value"].get<std::string>().find("What it is made of.") !=
        std::string::npos);
  CHECK(client.result(fix).is_array());
  std::vector<std::size_t> counts;
  for (const auto& message : client.sent) {
    if (message.value("method", "") == "textDocument/publishDiagnostics" &&
        message["params"]["uri"] == uri("try.op.json"))
      counts.push_back(message["params"]["diagnostics"].size());
  }
  REQUIRE_FALSE(counts.empty());
  CHECK(counts.front() > 0);
  CHECK(counts.back() == 0);
}
