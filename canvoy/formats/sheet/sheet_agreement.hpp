// Whether a data sheet agrees with itself: what its sections say of the device as a whole, and what
// its objects say.
//
//     check_agreement(sheet, findings);     // ProductNumber is 0; expected: 0x1A3, as 1018sub2 has
#pragma once

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// Adds warnings: the identity (1018h), what LSS and the mapping of PDOs need, the bit rate of a
/// configured device, and texts that are not ASCII where the form of the file wants ASCII (CiA
/// 306).
void check_agreement(const DataSheet& sheet, Findings& findings);

/// Writes into DeviceInfo what the objects say: the identity that 1018h has by default, how many
/// PDOs there are, and the granularity of their mapping: 0 where none can be written, else 1 bit
/// where it was 0.
void make_agree(DataSheet& sheet);

}  // namespace canvoy::formats
