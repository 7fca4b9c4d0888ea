// LS2 of edge_slope.pal.
#pragma once

#include "skills_pal/modules/signature.hpp"
#include "skills_pal/sensing/edge.hpp"
#include "skills_pal/sensing/literal_edge.hpp"
#include "skills_pal/sensing/motion.hpp"

namespace pal::skills {

/// By the meeting of two lines, or by the thesis's mask if the parameter `literal` says so.
template <class Interface>
class EdgeSensor final : public Interface {
  using Parameters = ArgumentOf<&Interface::start>;
  using Profile = ArgumentOf<&Interface::find_edge>;
  using Edge = ResultOf<&Interface::find_edge>;

 public:
  void start(const Parameters& parameters) override {
    literal_ = parameters.literal;
    last_y_ = 0;
  }

  Edge find_edge(const Profile& profile) override {
    Edge edge;
    edge.at = profile.taken;
    const sensing::Profile points{profile.x, profile.z, profile.valid};
    if (literal_) {
      if (const auto found = sensing::find_literal_edge(points)) {
        edge.seen = true;
        edge.y = found->y;
        edge.z = found->z;
        edge.slope = found->slope;
        edge.at += sensing::scan_time / 2;
      }
      return edge;
    }
    sensing::EdgeOptions options;
    options.expected = last_y_;
    if (const auto found = sensing::find_edge(points, options)) {
      edge.seen = true;
      edge.y = found->y;
      edge.z = found->z;
      edge.slope = found->beside().angle();
      edge.at += sensing::point_time(found->index);
      last_y_ = edge.y;
    }
    return edge;
  }

 private:
  bool literal_ = false;
  double last_y_ = 0;  // mm: of several edges the one that was followed, at first the one before the tool
};

}  // namespace pal::skills
