// Data sheets in files: EDS and DCF, XDD and XDC, recognized by content when read, and by name when
// written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::tools {

/// Throws Failure if the file cannot be read, or describes no object.
formats::DataSheet read_sheet_file(const std::string& path, formats::Findings& findings);

/// Parses the content of a file; it may describe nothing.
formats::DataSheet parse_sheet_text(std::string_view text, formats::Findings& findings);

/// The text for a file of this name: `.xdd`, `.xdc`, `.eds` or `.dcf`. Throws UsageError for
/// others.
std::string sheet_text(const formats::DataSheet& sheet, const std::string& path);

/// Throws UsageError unless the sheet of a node may have this name: `.dcf` or `.xdc`, which hold
/// values. `line` are the words of the verb that writes it, without the file: `clone`, `can0`,
/// `10`.
void require_values(const std::string& path, std::vector<std::string> line);

/// Text of a finding: `charger.eds:12: [1018sub1] DataType is 0x0005; expected: 0x0007`.
std::string finding_text(const std::string& path, const formats::Finding& finding);

}  // namespace canvoy::tools
