// Reads XDD and XDC files: data sheets in XML (CiA 311). If an object refers to a parameter of the
// application process (uniqueIDRef, as in files of CANopenNode), takes type, access, default or
// limits from it.
//
//     Findings findings;
//     DataSheet sheet = read_xdd(text, findings);
//     write_xdd(sheet);  // xdd_writer.hpp; with all that the file had and a DataSheet has not
#pragma once

#include <string>
#include <string_view>

#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats {

/// Reads any text; a text that is no XDD gives no objects.
DataSheet read_xdd(std::string_view text, Findings& findings);

/// True if a text is XML.
bool is_xml(std::string_view text);

}  // namespace canvoy::formats
