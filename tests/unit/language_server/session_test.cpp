// Sessions of an editor, on one thread.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "language_server/server.hpp"
#include "language_server/text.hpp"
#include "pal/support/file_system.hpp"
#include "programs/pal/reports/editor_proofs.hpp"

using namespace pal;
using Json = nlohmann::json;

namespace {

const std::string shared = R"(MESSAGE force : REAL N
CONDITION pressed FROM force "the tool presses"
DEVICE cell "measures forces"

Sensor Driver: SD1
BEGIN
  REPEAT
    WTM( request force from LS1 )
    TXM( request force from cell )
    WTM( force from cell )
    TXM( force to LS1 )
  UNTIL( forever )
END

Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request force from SD1 )
    WTM( force from SD1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
)";
const std::string skill = R"(USES "shared.pal"

SKILL feel
  SENSOR DRIVER  SD1
  LOGICAL SENSOR LS1
  SKILL METHOD   SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 2 ERROR  "any fault"

  REQUIREMENT soon : DURATION TO COMPLETION 0 AT MOST 20 ms
END SKILL

Skill Module: SM1
  ACTIVITY look READS force
BEGIN
  WTM( Coordinator )
  TXM( request force from LS1 )
  WTM( force from LS1 )
  look
  SPC( pressed )
  CASE
    ( pressed = TRUE ):
      TXM( Completion Protocol 0 )
    ( pressed = FALSE ):
      TXM( Completion Protocol 0 )
  END CASE
END
)";
const std::string cell = R"(ENVIRONMENT cell-one
  PROCESSOR P0
  DEVICE cell ON REQUEST 2 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P0 PRIORITY 2
  PLACE SD1 ON P0 PRIORITY 3
  TIME look OF SM1 : 1 TO 3 ms
END ENVIRONMENT
)";

std::string uri(const std::string& file) {
  return "file:///w/" + file;
}

/// A session that is replayed as a whole; each request is asked by its number.
class Client {
 public:
  explicit Client(Json settings = Json::object())
      : files_({{"/w/shared.pal", shared}, {"/w/feel.pal", skill}, {"/w/cell.pal", cell}}) {
    ask("initialize",
        {{"rootUri", "file:///w"},
         {"initializationOptions", std::move(settings)},
         {"capabilities",
          {{"textDocument", {{"completion", {{"completionItem", {{"snippetSupport", true}}}}}}}}}});
    tell("initialized", Json::object());
  }

  void raw(const std::string& line) { script_ += line + "\n"; }
  int ask(const std::string& method, const Json& params) {
    raw(Json{{"jsonrpc", "2.0"}, {"id", ++asked_}, {"method", method}, {"params", params}}.dump());
    return asked_;
  }
  void tell(const std::string& method, const Json& params) {
    raw(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
  }
  void open(const std::string& file, const std::string& text) {
    texts_[file] = text;
    tell("textDocument/didOpen",
         {{"textDocument", {{"uri", uri(file)}, {"languageId", "pal"}, {"version", 1}, {"text", text}}}});
  }
  /// Asks at the place of `word`, its occurrence number `which` from 0.
  int ask_at(const std::string& method, const std::string& file, const std::string& word, int which = 0,
             Json more = Json::object()) {
    std::size_t at = texts_.at(file).find(word);
    for (int i = 0; i < which; ++i) at = texts_.at(file).find(word, at + 1);
    REQUIRE(at != std::string::npos);
    const auto position = language_server::Text(texts_.at(file)).position(at);
    more["textDocument"] = {{"uri", uri(file)}};
    more["position"] = {{"line", position.line}, {"character", position.character}};
    return ask(method, more);
  }

  void run() {
    static const program::EditorProver prover;
    const language_server::Options options{"1", "file:///docs", &prover};
    std::istringstream lines(language_server::replay(script_, files_, options));
    for (std::string line; std::getline(lines, line);) sent.push_back(Json::parse(line));
  }
  const Json& answer(int id) const {
    static const Json none;
    for (const auto& message : sent) {
      if (message.contains("id") && message["id"] == id && !message.contains("method")) return message;
    }
    return none;
  }
  const Json& result(int id) const {
    INFO(answer(id).dump());
    REQUIRE(answer(id).contains("result"));
    return answer(id)["result"];
  }
  /// The last findings of a file.
  Json findings(const std::string& file) const {
    Json last = Json::array();
    for (const auto& message : sent) {
      if (message.value("method", "") == "textDocument/publishDiagnostics" &&
          message["params"]["uri"] == uri(file))
        last = message["params"]["diagnostics"];
    }
    return last;
  }

  std::vector<Json> sent;

 private:
  MemoryFileSystem files_;
  std::map<std::string, std::string> texts_;
  std::string script_;
  int asked_ = 0;
};

std::string applied(const std::string& text, Json edits) {
  std::sort(edits.begin(), edits.end(), [](const Json& a, const Json& b) {
    return std::pair(a["range"]["start"]["line"].get<int>(), a["range"]["start"]["character"].get<int>()) >
           std::pair(b["range"]["start"]["line"].get<int>(), b["range"]["start"]["character"].get<int>());
  });
  language_server::Text result(text);
  const auto at = [](const Json& position) {
    return language_server::Position{position["line"], position["character"]};
  };
  for (const auto& edit : edits)
    result.replace(at(edit["range"]["start"]), at(edit["range"]["end"]), edit["newText"].get<std::string>());
  return result.content();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::set<std::string> labels(const Json& items) {
  std::set<std::string> result;
  for (const auto& item : items) result.insert(item["label"].get<std::string>());
  return result;
}

}  // namespace

TEST_CASE("messages that the protocol forbids get its errors") {
  MemoryFileSystem files;
  const std::string sent = language_server::replay(
      R"({"jsonrpc":"2.0","id":1,"method":"textDocument/hover"}
nonsense
{"id":2}
{"jsonrpc":"2.0","id":3,"method":"initialize","params":{"capabilities":{}}}
{"jsonrpc":"2.0","id":4,"method":"no/such"}
{"jsonrpc":"2.0","id":5,"method":"textDocument/hover","params":{"textDocument":{"uri":"x:y"}}}
{"jsonrpc":"2.0","id":6,"method":"textDocument/hover","params":7}
{"jsonrpc":"2.0","method":"textDocument/didChange","params":[]}
{"jsonrpc":"2.0","id":7,"method":"shutdown"}
{"jsonrpc":"2.0","id":8,"method":"textDocument/hover","params":{}}
{"jsonrpc":"2.0","method":"exit"}
{"jsonrpc":"2.0","id":9,"method":"shutdown"}
)",
      files, {});
  std::vector<int> codes;
  std::istringstream lines(sent);
  for (std::string line; std::getline(lines, line);) {
    const Json message = Json::parse(line);
    codes.push_back(message.contains("error") ? message["error"]["code"].get<int>() : 0);
  }
  CHECK(codes == std::vector<int>{-32002, -32700, -32600, 0, -32601, -32602, -32602, 0, -32600});
}

TEST_CASE("a finding has its page and a cure that makes it go away") {
  Client client;
  const std::string wrong = replaced(skill, "WTM( force from LS1 )", "WTM( forse from LS1 )");
  client.open("feel.pal", wrong);
  const int actions = client.ask(
      "textDocument/codeAction",
      {{"textDocument", {{"uri", uri("feel.pal")}}},
       {"range", {{"start", {{"line", 17}, {"character", 0}}}, {"end", {{"line", 17}, {"character", 30}}}}},
       {"context", {{"diagnostics", Json::array()}}}});
  client.run();
  const Json findings = client.findings("feel.pal");
  REQUIRE(findings.size() == 1);
  CHECK(findings[0]["code"] == "PAL0202");
  CHECK(findings[0]["codeDescription"]["href"] == "file:///docs/reference/diagnostics.md#pal0202");
  CHECK(findings[0]["relatedInformation"][0]["location"]["uri"] == uri("shared.pal"));
  const Json& offered = client.result(actions);
  REQUIRE(offered.size() == 1);
  CHECK(offered[0]["title"] == "replace 'forse' by 'force'");
  CHECK(applied(wrong, offered[0]["edit"]["changes"][uri("feel.pal")]) == skill);
}

TEST_CASE("an edit of one line is checked; what is right has no finding") {
  Client client;
  client.open("feel.pal", skill);
  const auto change = [&](const std::string& text, int begin, int end, int version) {
    client.tell(
        "textDocument/didChange",
        {{"textDocument", {{"uri", uri("feel.pal")}, {"version", version}}},
         {"contentChanges",
          {{{"range",
             {{"start", {{"line", 18}, {"character", begin}}}, {"end", {{"line", 18}, {"character", end}}}}},
            {"text", text}}}}});
  };
  change("lok", 2, 6, 2);
  change("look", 2, 5, 3);
  client.run();
  std::vector<std::size_t> counts;
  for (const auto& message : client.sent) {
    if (message.value("method", "") != "textDocument/publishDiagnostics") continue;
    if (counts.empty() || message["params"]["diagnostics"].size() != counts.back())
      counts.push_back(message["params"]["diagnostics"].size());
  }
  CHECK(counts == std::vector<std::size_t>{0, 1, 0});
}

TEST_CASE("a file of modules is checked with the skills that use it") {
  Client client;
  client.open("shared.pal", shared);  // alone it would be a sketch, with a warning
  client.run();
  CHECK(client.findings("shared.pal").empty());
  Client other;
  other.open("shared.pal",
             replaced(shared, "WTM( request force from SM1 )", "WTM( request force from SM2 )"));
  other.run();
  CHECK(other.findings("shared.pal").size() == 1);
}

TEST_CASE("definition, references and rename reach all files") {
  Client client;
  client.open("feel.pal", skill);
  client.open("cell.pal", cell);
  const int definition = client.ask_at("textDocument/definition", "feel.pal", "force from LS1", 1);
  const int file = client.ask_at("textDocument/definition", "feel.pal", "shared.pal");
  const int references = client.ask_at("textDocument/references", "feel.pal", "pressed )", 0,
                                       {{"context", {{"includeDeclaration", true}}}});
  const int rename =
      client.ask_at("textDocument/rename", "cell.pal", "LS1", 0, {{"newName", "force-sensor"}});
  const int taken = client.ask_at("textDocument/rename", "cell.pal", "LS1", 0, {{"newName", "SD1"}});
  const int keyword = client.ask_at("textDocument/rename", "cell.pal", "LS1", 0, {{"newName", "CASE"}});
  const int number = client.ask_at("textDocument/prepareRename", "feel.pal", "0 )");
  const int prepare = client.ask_at("textDocument/prepareRename", "feel.pal", "look READS");
  client.run();
  REQUIRE(client.result(definition).size() == 1);
  CHECK(client.result(definition)[0]["uri"] == uri("shared.pal"));
  CHECK(client.result(definition)[0]["range"]["start"]["line"] == 0);
  CHECK(client.result(file)[0]["uri"] == uri("shared.pal"));
  CHECK(client.result(references).size() == 4);
  const Json& changes = client.result(rename)["changes"];
  CHECK(changes[uri("cell.pal")].size() == 1);
  CHECK(changes[uri("feel.pal")].size() == 3);
  CHECK(changes[uri("shared.pal")].size() == 3);
  CHECK(client.answer(taken).contains("error"));
  CHECK(client.answer(keyword).contains("error"));
  CHECK(client.answer(number).contains("error"));
  CHECK(client.result(prepare)["placeholder"] == "look");

  // What was renamed is right as before.
  Client renamed;
  renamed.open("cell.pal", applied(cell, changes[uri("cell.pal")]));
  renamed.open("shared.pal", applied(shared, changes[uri("shared.pal")]));
  renamed.open("feel.pal", applied(skill, changes[uri("feel.pal")]));
  renamed.run();
  for (const char* each : {"cell.pal", "shared.pal", "feel.pal"}) CHECK(renamed.findings(each).empty());
}

TEST_CASE("hover tells what is known of a name and of a statement") {
  Client client;
  client.open("feel.pal", skill);
  const int message = client.ask_at("textDocument/hover", "feel.pal", "force from LS1", 1);
  const int activity = client.ask_at("textDocument/hover", "feel.pal", "look READS");
  const int wait = client.ask_at("textDocument/hover", "feel.pal", "WTM( force");
  const int requirement = client.ask_at("textDocument/hover", "feel.pal", "soon");
  const int nothing = client.ask_at("textDocument/hover", "feel.pal", "END CASE");
  client.run();
  const auto text = [&](int id) { return client.result(id)["contents"]["value"].get<std::string>(); };
  CHECK(text(message).find("Carries: real, in N") != std::string::npos);
  CHECK(text(message).find("`LS1` → `SM1`") != std::string::npos);
  CHECK(text(activity).find("TIME look OF SM1 : 1 TO 3 ms") != std::string::npos);
  CHECK(text(wait).find("`force` is sent by `LS1`") != std::string::npos);
  CHECK(text(wait).find("TXM( force to SM1 )") != std::string::npos);
  CHECK(text(requirement).find("**holds**, 5 ms of 20 ms, exact") != std::string::npos);
  CHECK(client.result(nothing).is_null());
}

TEST_CASE("completion knows kinds and layers") {
  Client client;
  const std::string from = replaced(skill, "WTM( force from LS1 )", "WTM( force from ");
  client.open("feel.pal", from);
  const int sender = client.ask_at("textDocument/completion", "feel.pal", "\n  look\n");
  const std::string spc = replaced(skill, "SPC( pressed )", "SPC( pr");
  client.open("feel.pal", spc);
  const int condition = client.ask_at("textDocument/completion", "feel.pal", "\n  CASE");
  client.open("feel.pal", replaced(skill, "  look\n", "  \n"));
  const int statement = client.ask_at("textDocument/completion", "feel.pal", "\n  SPC");
  client.open("feel.pal", replaced(skill, "SENSOR DRIVER  SD1", "SENSOR DRIVER  "));
  const int driver = client.ask_at("textDocument/completion", "feel.pal", "\n  LOGICAL");
  client.run();
  CHECK(labels(client.result(sender)).contains("LS1"));
  CHECK_FALSE(labels(client.result(sender)).contains("SD1"));   // not a neighbour
  CHECK_FALSE(labels(client.result(sender)).contains("SM1"));   // itself
  CHECK_FALSE(labels(client.result(sender)).contains("cell"));  // a device
  CHECK(labels(client.result(condition)) == std::set<std::string>{"pressed"});
  CHECK(labels(client.result(statement)).contains("look"));
  CHECK(labels(client.result(statement)).contains("REPEAT"));
  CHECK_FALSE(labels(client.result(statement)).contains("ENVIRONMENT"));
  CHECK(labels(client.result(driver)).contains("SD1"));
  CHECK_FALSE(labels(client.result(driver)).contains("LS1"));
}

TEST_CASE("formatting leads to the canonical layout by edits of what differs") {
  Client client;
  const std::string untidy = replaced(replaced(skill, "  look\n", "     Look\n"), "     Look", "     look");
  client.open("feel.pal", untidy);
  const int whole = client.ask("textDocument/formatting",
                               {{"textDocument", {{"uri", uri("feel.pal")}}}, {"options", Json::object()}});
  const int elsewhere = client.ask(
      "textDocument/rangeFormatting",
      {{"textDocument", {{"uri", uri("feel.pal")}}},
       {"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 5}, {"character", 0}}}}}});
  client.open("feel.pal", skill + "WTM(");
  const int broken = client.ask("textDocument/formatting", {{"textDocument", {{"uri", uri("feel.pal")}}}});
  client.run();
  CHECK(client.result(whole).size() == 1);
  CHECK(applied(untidy, client.result(whole)) == skill);
  CHECK(client.result(elsewhere).empty());
  CHECK(client.result(broken).is_null());
}

TEST_CASE("a bound stands beside its requirement, and a failing one is a finding") {
  Client client({{"commands", {"pal.showChart", "pal.showGraph"}}, {"pictures", true}});
  client.open("feel.pal", skill);
  const Json all{{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 99}, {"character", 0}}}};
  const int hints =
      client.ask("textDocument/inlayHint", {{"textDocument", {{"uri", uri("feel.pal")}}}, {"range", all}});
  const int lenses = client.ask("textDocument/codeLens", {{"textDocument", {{"uri", uri("feel.pal")}}}});
  const int list = client.ask("pal/requirements", {{"textDocument", {{"uri", uri("feel.pal")}}}});
  client.open("feel.pal", replaced(skill, "AT MOST 20 ms", "AT MOST 4 ms"));
  client.run();
  REQUIRE(client.result(hints).size() == 1);
  CHECK(client.result(hints)[0]["label"] == "5 ms of 20 ms, exact");
  CHECK(client.result(hints)[0]["position"]["line"] == 9);
  CHECK(client.result(lenses).size() == 2);
  CHECK(client.result(list)[0]["environment"] == "cell-one");
  CHECK(client.result(list)[0]["requirements"][0]["state"] == "holds");
  REQUIRE(client.findings("feel.pal").size() == 1);
  CHECK(client.findings("feel.pal")[0]["code"] == "PAL0890");
}

TEST_CASE("pictures lead from their elements to the text") {
  Client client;
  client.open("feel.pal", skill);
  const Json file{{"uri", uri("feel.pal")}};
  const int pan = client.ask("pal/picture", {{"textDocument", file}, {"kind", "pan"}, {"module", "LS1"}});
  const int atc = client.ask("pal/picture", {{"textDocument", file}, {"kind", "atc"}, {"dark", true}});
  const int none = client.ask("pal/picture", {{"textDocument", file}, {"kind", "pan"}, {"module", "XX"}});
  const int wrong = client.ask("pal/picture", {{"textDocument", file}, {"kind", "map"}});
  client.run();
  for (const int id : {pan, atc}) {
    const Json& picture = client.result(id);
    const std::string svg = picture["svg"];
    INFO(picture["reason"]);
    REQUIRE(picture["places"].size() > 4);
    std::set<std::string> seen;
    for (const auto& place : picture["places"]) {
      const std::string mark = " id=\"" + place["id"].get<std::string>() + "\"";
      CHECK(seen.insert(place["id"]).second);
      const auto at = svg.find(mark);
      CHECK(at != std::string::npos);
      CHECK(svg.find(mark, at + 1) == std::string::npos);
    }
  }
  CHECK(client.result(pan)["places"][0]["uri"] == uri("shared.pal"));
  CHECK(client.result(atc)["requirement"] == "soon");
  CHECK(client.result(atc)["state"] == "holds");
  CHECK(client.result(none)["svg"] == "");
  CHECK(client.result(none)["reason"] != "");
  CHECK(client.answer(wrong).contains("error"));
}

TEST_CASE("outline, folds, links and colours") {
  Client client;
  client.open("feel.pal", skill);
  const Json file{{"textDocument", {{"uri", uri("feel.pal")}}}};
  const int symbols = client.ask("textDocument/documentSymbol", file);
  const int folds = client.ask("textDocument/foldingRange", file);
  const int links = client.ask("textDocument/documentLink", file);
  const int colours = client.ask("textDocument/semanticTokens/full", file);
  const int everywhere = client.ask("workspace/symbol", {{"query", "ls1"}});
  const int highlights = client.ask_at("textDocument/documentHighlight", "feel.pal", "pressed )");
  client.run();
  REQUIRE(client.result(symbols).size() == 2);
  CHECK(client.result(symbols)[0]["name"] == "feel");
  CHECK(client.result(symbols)[0]["children"].size() == 3);
  CHECK(client.result(symbols)[1]["children"][0]["name"] == "look");
  CHECK(client.result(folds).size() == 3);
  CHECK(client.result(links)[0]["target"] == uri("shared.pal"));
  CHECK(client.result(colours)["data"].size() % 5 == 0);
  CHECK(client.result(everywhere).size() == 1);
  CHECK(client.result(highlights).size() == 3);
}
