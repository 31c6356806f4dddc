// Writes XDD and XDC files by the schema of CiA 311 1.1: elements that it declares globally have
// its namespace, all others have none.
#pragma once

#include <string>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::formats {

/// Writes an XDC if the sheet is configured, else an XDD without values. Keeps elements and
/// attributes of the file that the sheet was read from, known or not. Writes characters that XML
/// cannot have as plain_text() does (CiA 311 1.1).
std::string write_xdd(const DataSheet& sheet);

}  // namespace canvoy::formats
