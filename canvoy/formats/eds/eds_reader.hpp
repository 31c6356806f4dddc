// Reads EDS and DCF files (CiA 306), tolerant of the deviations of real files: takes what can be
// understood, and reports each deviation as a finding.
//
//     Findings findings;
//     const DataSheet sheet = read_eds(text, findings);
#pragma once

#include <string_view>
#include <vector>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::formats {

/// Deviations, in the order of the file.
using Findings = std::vector<Finding>;

/// Reads any text, in the encodings of encoding.hpp; a text that is no EDS gives no objects.
/// Reports at most `findings_max` errors and as many warnings, and one more of each if there are
/// others. Expands objects with entries that are not written out (CompactSubObj), up to
/// `compact_bytes_max` together.
inline constexpr std::size_t findings_max = 10'000;
/// Of expanded entries, in bytes.
inline constexpr std::size_t compact_bytes_max = 64 * 1024 * 1024;
/// Reads a text. `findings` gets what it deviates in, behind what it has.
DataSheet read_eds(std::string_view text, Findings& findings);

}  // namespace canvoy::formats
