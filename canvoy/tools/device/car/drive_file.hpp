// Reads the NMEA 0183 file of a drive recorded by a satellite receiver.
//
//     network.record = read_drive_file("town.nmea");
#pragma once

#include <memory>
#include <string>

#include "canvoy/worlds/car/drive_record.hpp"

namespace canvoy::tools {

/// `3 of 600 lines are passed over: 2 with a wrong checksum, 1 broken`; empty if there are none.
std::string passed_over_text(const car::DriveRecord& record);

/// Reads a drive. Reports skipped lines on stderr. Throws Failure if the file cannot be read, or
/// has no motion.
std::shared_ptr<const car::DriveRecord> read_drive_file(const std::string& path);

}  // namespace canvoy::tools
