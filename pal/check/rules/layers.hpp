// The layers of the thesis, figure 3.3, and who may talk with whom.
#pragma once

#include <cstdint>
#include <optional>

#include "pal/pan/network.hpp"

namespace pal::check {

/// The boxes of the figure from top to bottom.
enum class Layer : std::uint8_t { skill, logical_sensor, machine_controller, sensor_driver, device };

/// Of a module of this kind; nothing: of a device.
Layer layer_of(std::optional<pan::ModuleKind> kind);

/// Whether messages may pass between the two, in either direction.
bool may_talk(Layer a, Layer b);

}  // namespace pal::check
