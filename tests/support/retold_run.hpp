// A run of the runtime in the words of the analysis.
#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "analyzer/problem/problem.hpp"
#include "analyzer/runs/concrete_run.hpp"
#include "pal/trace/trace.hpp"

namespace pal::test {

/// The run with the tables of `problem`. Every name is there, and once; requires it.
inline trace::Trace retold_run(trace::Trace run, const analyzer::Problem& problem) {
  trace::Trace tables = analyzer::empty_trace(problem);
  std::map<std::string, int> actors;
  for (std::size_t a = 0; a < tables.actors.size(); ++a) {
    INFO(tables.actors[a].name);
    REQUIRE(actors.emplace(tables.actors[a].name, static_cast<int>(a)).second);
  }
  std::map<std::tuple<std::string, std::string, int>, int> statements;
  for (std::size_t s = 0; s < tables.statements.size(); ++s) {
    const trace::Statement& of = tables.statements[s];
    statements.emplace(std::tuple(of.module, of.text, of.line), static_cast<int>(s));
  }
  for (trace::Event& event : run.events) {
    if (event.actor >= 0) {
      const trace::Actor& actor = run.actors[static_cast<std::size_t>(event.actor)];
      INFO(actor.name);
      const auto found = actors.find(actor.name);
      REQUIRE(found != actors.end());
      event.actor = found->second;
      const trace::Actor& same = tables.actors[static_cast<std::size_t>(event.actor)];
      CHECK(same.processor == actor.processor);
      CHECK(same.priority == actor.priority);
    }
    if (event.statement < 0) continue;
    const trace::Statement& of = run.statements[static_cast<std::size_t>(event.statement)];
    const auto found = statements.find(std::tuple(of.module, of.text, of.line));
    event.statement = found == statements.end() ? -2 : found->second;
  }
  // The start of the skill is no statement of a problem.
  std::erase_if(run.events, [](const trace::Event& event) {
    return event.statement == -2 && event.kind == trace::Kind::done;
  });
  tables.events = std::move(run.events);
  return tables;
}

}  // namespace pal::test
