// A drive that a satellite receiver recorded, as a file in NMEA 0183.
//
//     network.record = read_drive_file("town.nmea");
#pragma once

#include <memory>
#include <string>

#include "canvoy/sim/car/drive_record.hpp"

namespace canvoy::tools {

/// `3 of 600 lines are passed over: 2 with a wrong checksum, 1 broken`; empty where there are none.
std::string passed_over_text(const car::DriveRecord& record);

/// Tells of lines that are passed over on stderr. Throws Failure where the file cannot be read, and
/// where no car moves in it.
std::shared_ptr<const car::DriveRecord> read_drive_file(const std::string& path);

}  // namespace canvoy::tools
