#pragma once

#include <memory>

#include "pal/runtime/skill.hpp"

/// Switches a lamp, on first.
std::unique_ptr<pal::runtime::Skill> blink();
