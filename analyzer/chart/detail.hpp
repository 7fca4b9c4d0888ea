// Which parts of a run are worth enlarging, and how much of a run is worth drawing.
#pragma once

#include <vector>

#include "analyzer/chart/layer.hpp"
#include "analyzer/chart/text_width.hpp"

namespace pal::analyzer::chart {

/// The window that the options of the first layer ask for. If they ask for none: the highlighted intervals of
/// all layers with some context, or all of the runs. In shifted time.
Window overview_window(const std::vector<Layer>& layers);

/// The stretches in and around the highlighted intervals in which something runs, in one scale large enough
/// for numbered bars on `width`. Empty if the whole window in that width already shows every action that
/// large, or if nothing is highlighted. Of long actions only the ends are shown. If not everything can be
/// shown, the order of preference is: the end of the interval, its beginning, the places where one part of
/// the explanation ends and the next begins. Each of these may be shown in part. Then come the stretches in
/// which most happens.
std::vector<Window> detail_windows(const std::vector<Layer>& layers, const Window& window, Length width,
                                   Length fold);

}  // namespace pal::analyzer::chart
