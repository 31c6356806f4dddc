// Writes EDS and DCF files (CiA 306): all that a data sheet says, in the order in which others
// expect it.
#pragma once

#include <string>

#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// A DCF where the sheet has values, else an EDS.
std::string write_eds(const DataSheet& sheet);

}  // namespace canvoy::formats
