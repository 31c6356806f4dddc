// Writes XDD and XDC files by the schema of CiA 311 1.1: elements that it declares globally have
// its namespace, all others have none.
#pragma once

#include <string>

#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// An XDC where the sheet is configured, else an XDD without values, by the schema of CiA 311 1.1.
/// Elements and attributes of the file that the sheet was read from stay, whether they are known or
/// not. Characters that XML cannot have are written as plain_text() does.
std::string write_xdd(const DataSheet& sheet);

}  // namespace canvoy::formats
