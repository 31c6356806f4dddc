// Checks that a data sheet is consistent: its sections on the device as a whole against its
// objects.
//
//     check_agreement(sheet, findings);     // ProductNumber is 0; expected: 0x1A3, as 1018sub2 has
#pragma once

#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats {

/// Adds warnings on the identity (1018h), on what LSS and PDO mapping need, on the bit rate of a
/// configured device, and on texts that are not ASCII where the file format requires ASCII (CiA
/// 306).
void check_agreement(const DataSheet& sheet, Findings& findings);

/// Sets DeviceInfo from the objects: identity from the defaults of 1018h, number of PDOs, and
/// granularity of the mapping: 0 if none can be written, else 1 bit if it was 0.
void make_agree(DataSheet& sheet);

}  // namespace canvoy::formats
