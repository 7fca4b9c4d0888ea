// An operation as a story with drawings, for people who do not read files (thesis, sections 2.3.6 and 7.2).
#pragma once

#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/happened.hpp"
#include "operations/model.hpp"

namespace pal::operations {

/// One operation of the program as Graphviz DOT, from left to right. Skills are boxes, hierarchical icons
/// shadowed boxes, tests hexagons, and CASEs diamonds. Codes stand on the lines. With a run: how often each
/// icon had a step; those that had none are pale.
std::string to_dot(const Program& program, std::size_t operation, const Happened* run = nullptr);

/// An icon that acts, as people are told of it.
struct StoryScene {
  std::string icon, title;
  std::vector<std::string> sentences;  // each a paragraph
  std::vector<std::string> branches;   // where the story goes on, by code
};

/// One operation.
struct StoryChapter {
  std::string operation;
  std::vector<std::string> introduction;  // each a paragraph
  std::vector<std::string> course;        // of a run: its steps
  std::vector<StoryScene> scenes;
  std::string dot;  // its picture, as to_dot() makes it
};

/// The main operation first. The program has no errors of shape.
std::vector<StoryChapter> story(const Program& program, const Skills& skills, const Happened* run = nullptr);

/// Scenes in the order in which the token first comes to them. A scene says what each skill needs, does and
/// leaves, from its template, and where the story goes on, by code. With a run it also says what happened
/// when. The program has no errors of shape.
std::string storyboard_markdown(const Program& program, const Skills& skills, const Happened* run = nullptr);

/// The same as a page that needs nothing else, with the pictures in it. Throws std::runtime_error if
/// Graphviz cannot draw.
std::string storyboard_html(const Program& program, const Skills& skills, const Happened* run = nullptr);

}  // namespace pal::operations
