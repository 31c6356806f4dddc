// Adds objects that a sheet has without describing each: PDO parameters that DeviceInfo counts
// (CompactPDO), and those of plugged-in modules (CiA 306).
//
//     add_compact_pdos(sheet, findings);    // 1400h, 1600h, 1800h, 1A00h ...
//     add_modules(sheet, findings);         // what [M1SubExt6000] and [ConnectedModules] say
#pragma once

#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats {

/// Adds PDO parameters if `CompactPDO` is not 0: as many RPDOs and TPDOs as NrOfRXPDO and NrOfTXPDO
/// give, at most 512 each, including those that are described. Bit n of CompactPDO means that
/// sub-index n + 1 of the communication parameter exists. If only one of the two objects of a PDO
/// is described, adds the other.
void add_compact_pdos(DataSheet& sheet, Findings& findings);

/// Adds the objects of each module of `[ConnectedModules]`: its fixed objects (`[M1Fixed2000]`),
/// and after the last entry of an object, the entries that extend it (`[M1SubExt6000]`, `Count` of
/// them). What cannot be added becomes a finding. A sheet that only offers modules is unchanged,
/// with a finding.
void add_modules(DataSheet& sheet, Findings& findings);

}  // namespace canvoy::formats
