// XDD and XDC files (CiA 311): data sheets in XML. Where an object leaves its type, access, default
// or limits to a parameter of the application process (uniqueIDRef, as in CANopenNode's files),
// they are read there.
//
//     Findings findings;
//     DataSheet sheet = read_xdd(text, findings);
//     write_xdd(sheet);  // with all that the file had beside what a DataSheet knows
#pragma once

#include <string>
#include <string_view>

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// Any text is read; what is no XDD at all has no objects.
DataSheet read_xdd(std::string_view text, Findings& findings);

/// An XDC where the sheet is configured, else an XDD without values, by the schema of CiA 311 1.1.
/// Elements and attributes of the file that the sheet was read from stay, whether they are known or
/// not. Characters that XML cannot have are written as plain_text() does.
std::string write_xdd(const DataSheet& sheet);

/// Whether a text is XML.
bool is_xml(std::string_view text);

}  // namespace canvoy::formats
