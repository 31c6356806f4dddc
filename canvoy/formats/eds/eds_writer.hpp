// Writes EDS and DCF files (CiA 306): the whole content of a data sheet, in the order that other
// tools expect.
#pragma once

#include <string>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::formats {

/// Writes a DCF if the sheet has values, else an EDS.
std::string write_eds(const DataSheet& sheet);

}  // namespace canvoy::formats
