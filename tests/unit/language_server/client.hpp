// A client on one thread, three files that belong together, and what tests do with answers.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "language_server/server.hpp"
#include "language_server/text.hpp"
#include "pal/support/file_system.hpp"
#include "programs/pal/reports/editor_proofs.hpp"

namespace pal::language_server::test {

using Json = nlohmann::json;

inline const std::string shared = R"(MESSAGE force : REAL N
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
inline const std::string skill = R"(USES "shared.pal"

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
inline const std::string cell = R"(ENVIRONMENT cell-one
  PROCESSOR P0
  DEVICE cell ON REQUEST 2 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P0 PRIORITY 2
  PLACE SD1 ON P0 PRIORITY 3
  TIME look OF SM1 : 1 TO 3 ms
END ENVIRONMENT
)";

inline std::string uri(const std::string& file) {
  return "file:///w/" + file;
}

/// A session that is replayed as a whole; each request is asked by its number.
class Client {
 public:
  explicit Client(Json settings = Json::object())
      : Client(std::move(settings),
               {{"/w/shared.pal", shared}, {"/w/feel.pal", skill}, {"/w/cell.pal", cell}}) {}
  Client(Json settings, std::map<std::string, std::string> files) : files_(std::move(files)) {
    ask("initialize",
        {{"rootUri", "file:///w"},
         {"initializationOptions", std::move(settings)},
         {"capabilities",
          {{"window", {{"workDoneProgress", true}}},
           {"textDocument", {{"completion", {{"completionItem", {{"snippetSupport", true}}}}}}}}}});
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
    const auto position = Text(texts_.at(file)).position(at);
    more["textDocument"] = {{"uri", uri(file)}};
    more["position"] = {{"line", position.line}, {"character", position.character}};
    return ask(method, more);
  }

  void run() {
    static const program::EditorProver prover;
    run(prover);
  }
  void run(const Prover& prover) {
    const Options options{"1", "file:///docs", &prover, 60};
    std::istringstream lines(replay(script_, files_, options));
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

inline std::string applied(const std::string& text, Json edits) {
  std::sort(edits.begin(), edits.end(), [](const Json& a, const Json& b) {
    return std::pair(a["range"]["start"]["line"].get<int>(), a["range"]["start"]["character"].get<int>()) >
           std::pair(b["range"]["start"]["line"].get<int>(), b["range"]["start"]["character"].get<int>());
  });
  Text result(text);
  const auto at = [](const Json& position) { return Position{position["line"], position["character"]}; };
  for (const auto& edit : edits)
    result.replace(at(edit["range"]["start"]), at(edit["range"]["end"]), edit["newText"].get<std::string>());
  return result.content();
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline std::set<std::string> labels(const Json& items) {
  std::set<std::string> result;
  for (const auto& item : items) result.insert(item["label"].get<std::string>());
  return result;
}

}  // namespace pal::language_server::test
