// Random skills as generated C++, compiled into this program.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pal/runtime/skill.hpp"

namespace pal::test {

/// What is written by hand of a random skill: activities do nothing, decisions are dealt out.
struct CompiledSkill {
  std::uint64_t seed = 0;
  const char* text = "";  // the PAL that it was generated from
  std::unique_ptr<runtime::Skill> (*make)(std::function<std::uint64_t(std::uint64_t)> dealer) = nullptr;
};

/// All of them, in the order of their seeds. Generated, too.
std::vector<CompiledSkill> compiled_skills();

}  // namespace pal::test
