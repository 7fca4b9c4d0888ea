// The skill, ready to run.
#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

std::unique_ptr<pal::runtime::Skill> pull_test_skill();
