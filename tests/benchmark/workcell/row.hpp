// The rows of the workcell's table of figures. One more: a file with a function, its declaration here, its
// name in main.cpp's list.
#pragma once

#include <string>
#include <vector>

namespace pal::bench {

struct Row {
  std::string what;
  std::string measured;
  std::string required;  // empty: for information
  bool met = true;
};

std::vector<Row> speed_rows();    // steps a second, bare and with everything
std::vector<Row> memory_rows();   // of a whole run
std::vector<Row> motion_rows();   // where the arm is, beside where it should be
std::vector<Row> alter_rows();    // answers to ALTER
std::vector<Row> scan_rows();     // of the range finder, beside physics without it
std::vector<Row> grasp_rows();    // creep and drift of a part in the gripper
std::vector<Row> range_rows();    // distances and edges from profiles, beside the true ones
std::vector<Row> picture_rows();  // CPU of pictures and of frames of a video

}  // namespace pal::bench
