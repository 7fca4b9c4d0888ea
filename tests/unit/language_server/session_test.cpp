// Sessions of an editor, on one thread.
#include "tests/unit/language_server/client.hpp"

using namespace pal;
using namespace pal::language_server;
using namespace pal::language_server::test;

TEST_CASE("messages that the protocol forbids get its errors") {
  MemoryFileSystem files;
  const std::string sent = replay(
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
  CHECK(findings[0]["data"] == Json{{"finding", "unknown_message"}, {"arguments", {{"message", "forse"}}}});
  CHECK(findings[0]["relatedInformation"][0]["location"]["uri"] == uri("shared.pal"));
  const Json& offered = client.result(actions);
  REQUIRE(offered.size() == 1);
  CHECK(offered[0]["title"] == "replace 'forse' by 'force'");
  CHECK(applied(wrong, offered[0]["edit"]["changes"][uri("feel.pal")]) == skill);
}

TEST_CASE("an edit of one line is checked, what is right has no finding") {
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
  CHECK(text(message).find("- Content: real, in N") != std::string::npos);
  CHECK(text(message).find("- Ways: LS1 → SM1, cell → SD1, SD1 → LS1") != std::string::npos);
  CHECK(text(message).find("- Requests: SM1 → LS1, LS1 → SD1, SD1 → cell") != std::string::npos);
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
  const std::string half_typed = replaced(untidy, "END SKILL", "  PARAMETER\nEND SKILL");
  client.open("feel.pal", half_typed);
  const int broken = client.ask("textDocument/formatting", {{"textDocument", {{"uri", uri("feel.pal")}}}});
  client.run();
  CHECK(client.result(whole).size() == 1);
  CHECK(applied(untidy, client.result(whole)) == skill);
  CHECK(client.result(elsewhere).empty());
  CHECK(applied(half_typed, client.result(broken)) == replaced(skill, "END SKILL", "  PARAMETER\nEND SKILL"));
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
  REQUIRE(client.result(hints).size() > 1);  // shares stand behind statements
  CHECK(client.result(hints)[0]["label"] == "5 ms of 20 ms, exact");
  CHECK(client.result(hints)[0]["position"]["line"] == 9);
  CHECK(client.result(lenses).size() == 2);
  CHECK(client.result(list)[0]["environment"] == "cell-one");
  CHECK(client.result(list)[0]["environmentUri"] == uri("cell.pal"));
  CHECK(client.result(list)[0]["requirements"][0]["state"] == "holds");
  REQUIRE(client.findings("feel.pal").size() == 2);  // where it stands, and at the statement to change
  CHECK(client.findings("feel.pal")[0]["code"] == "PAL0890");
  CHECK(client.findings("feel.pal")[1]["range"]["start"]["line"] == 18);
}

TEST_CASE("pictures lead from their elements to the text") {
  Client client;
  client.open("feel.pal", skill);
  const Json file{{"uri", uri("feel.pal")}};
  const int pan = client.ask("pal/picture", {{"textDocument", file}, {"kind", "pan"}, {"module", "LS1"}});
  const int atc = client.ask("pal/picture", {{"textDocument", file}, {"kind", "atc"}, {"dark", true}});
  const int narrow = client.ask("pal/picture", {{"textDocument", file}, {"kind", "atc"}, {"narrow", true}});
  const int none = client.ask("pal/picture", {{"textDocument", file}, {"kind", "pan"}, {"module", "XX"}});
  const int wrong = client.ask("pal/picture", {{"textDocument", file}, {"kind", "map"}});
  client.run();
  for (const int id : {pan, atc, narrow}) {
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
  CHECK(client.result(atc)["svg"].get<std::string>().find(" width=\"940\"") != std::string::npos);
  CHECK(client.result(narrow)["svg"].get<std::string>().find(" width=\"450\"") != std::string::npos);
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
