// Data sheets in files: EDS and DCF, XDD and XDC, told apart by what is in them when they are read,
// and by their name when they are written.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::tools {

/// Throws Failure where the file cannot be read, or describes no object.
formats::DataSheet read_sheet_file(const std::string& path, formats::Findings& findings);

/// The content of a file; it may describe nothing.
formats::DataSheet parse_sheet_text(std::string_view text, formats::Findings& findings);

/// The text of a file of this name: `.xdd`, `.xdc`, `.eds` or `.dcf`. Throws UsageError for others.
std::string sheet_text(const formats::DataSheet& sheet, const std::string& path);

/// `charger.eds:12: [1018sub1] DataType is 0x0005; expected: 0x0007`
std::string finding_text(const std::string& path, const formats::Finding& finding);

}  // namespace canvoy::tools
