// Objects that a sheet has without describing each: PDO parameters that DeviceInfo counts
// (CompactPDO), and those of the modules that are plugged in (CiA 306).
//
//     add_compact_pdos(sheet, findings);    // 1400h, 1600h, 1800h, 1A00h ...
//     add_modules(sheet, findings);         // what [M1SubExt6000] and [ConnectedModules] say
#pragma once

#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats {

/// Where `CompactPDO` is not 0: as many RPDOs and TPDOs as NrOfRXPDO and NrOfTXPDO say, at most 512
/// each, counted with those that are described. Bit n of CompactPDO says that sub-index n + 1 of
/// the communication parameter is there. Of a PDO of which one object is described, the other is
/// made.
void add_compact_pdos(DataSheet& sheet, Findings& findings);

/// For each module of `[ConnectedModules]`: its fixed objects (`[M1Fixed2000]`), and behind the
/// last entry of an object, those by which it extends it (`[M1SubExt6000]`, `Count` of them). What
/// cannot be made becomes a finding. A sheet that only offers modules stays as it is, and says so.
void add_modules(DataSheet& sheet, Findings& findings);

}  // namespace canvoy::formats
