// log.csv: one line a millisecond, with everything that a plot may want.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "sim/report/message_log.hpp"
#include "sim/report/sample_spool.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// A header row, then a row a sample. Names end in their units; the columns are in docs/workcell/reports.md.
/// After the arm's come those of the devices, named device.message.field: the last message up to this sample,
/// empty before the first one.
std::string log_table(const std::vector<Sample>& log, const MessageLog& messages);
/// The same of samples that need not be in memory.
void write_log_table(const SampleSource& samples, const MessageLog& messages, std::ostream& out);

/// Degrees about x, then y, then z of frame 0, each in the unturned frame: as ALTER counts them. The first is
/// from -90 to 270: a tool that points down has 180, and noise does not make -180 of it.
Eigen::Vector3d turn_angles(const Eigen::Quaterniond& turn);

}  // namespace pal::sim
