// Whether a data sheet says what CiA 306, CiA 301 and a profile ask for: strictly, where reading is
// forgiving.
//
//     Findings findings;
//     const DataSheet sheet = read_eds(text, findings);
//     check_sheet(sheet, &cia447::profile, findings);
#pragma once

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// Adds what is wrong. `profile` may be null.
void check_sheet(const DataSheet& sheet, const Profile* profile, Findings& findings);

}  // namespace canvoy::formats
