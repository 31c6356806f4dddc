// XDD and XDC files (CiA 311): data sheets in XML. Where an object leaves its type, access, default
// or limits to a parameter of the application process (uniqueIDRef, as in CANopenNode's files),
// they are read there.
//
//     Findings findings;
//     DataSheet sheet = read_xdd(text, findings);
//     write_xdd(sheet);  // xdd_writer.hpp; with all that the file had and a DataSheet has not
#pragma once

#include <string>
#include <string_view>

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// Any text is read; what is no XDD at all has no objects.
DataSheet read_xdd(std::string_view text, Findings& findings);

/// Whether a text is XML.
bool is_xml(std::string_view text);

}  // namespace canvoy::formats
