// Reads EDS and DCF files (CiA 306), as forgiving as real ones need it: what can be understood is
// taken, and each deviation becomes a finding.
//
//     Findings findings;
//     const DataSheet sheet = read_eds(text, findings);
#pragma once

#include <string_view>
#include <vector>

#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

using Findings = std::vector<Finding>;

/// Any text is read, in the encodings of encoding.hpp; what is no EDS at all has no objects. At
/// most `findings_max` errors and as many warnings are told, and one more of each that there are
/// others. Objects whose entries are not written out (CompactSubObj) are expanded up to
/// `compact_bytes_max` together.
inline constexpr std::size_t findings_max = 10'000;
inline constexpr std::size_t compact_bytes_max = 64 * 1024 * 1024;
DataSheet read_eds(std::string_view text, Findings& findings);

}  // namespace canvoy::formats
