// The threads of a skill, with their names and places. They are its modules, and the blocks of CONCURRENT in
// them and in what they execute (docs/reference/execution-model.md, Threads and processors).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::pan {

/// The name of a block of a module whose body `runner` runs. `text` is the name of the block within its
/// module, "CM1.2". If a block executes the module, its name stands in front: "SM1.1/CM1.2".
std::string block_name(const std::string& runner, bool runner_is_block, const std::string& text);

struct SkillThread {
  std::string name;
  ModuleId module;                    // in whose text it stands
  std::size_t index = 0;              // in Module::threads
  std::optional<std::size_t> parent;  // of a block: the thread whose CONCURRENT begins it
  std::optional<std::size_t> runner;  // of a block: the thread that runs the body of its module
};

/// All threads of the skill, each block after its parent, each name once. However often a thread executes a
/// module, it has one set of the module's blocks. Blocks that execute modules with blocks multiply. After
/// `most` threads the search ends, and `most` + 1 threads are given.
std::vector<SkillThread> threads_of(const Network& network, std::size_t most);

/// The module of the last block or module in a thread's name: "CM1" of "SM1.1/CM1.2".
std::string module_of_thread(const std::string& name);

/// Where the environment places a thread by name. A block of an executed module may have a place of its own.
/// Or it has the place that is given for that block wherever it runs: "PLACE CM1.2 …" also places
/// SM1.1/CM1.2. The longest name counts. nullptr: no place is given.
const Placement* place_of(const Environment& environment, const std::string& thread);

}  // namespace pal::pan
