// Checks a data sheet strictly against CiA 306, CiA 301 and a profile, where reading is tolerant.
//
//     Findings findings;
//     const DataSheet sheet = read_eds(text, findings);
//     check_sheet(sheet, &cia447::profile, findings);
#pragma once

#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats {

/// Adds a finding for each deviation. `profile` may be null.
void check_sheet(const DataSheet& sheet, const Profile* profile, Findings& findings);

}  // namespace canvoy::formats
