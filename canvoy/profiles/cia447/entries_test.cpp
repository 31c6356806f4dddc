// CiA 447-3: the entry descriptions, taken from the text. Where an erratum decided, it stands
// beside.
#include <gtest/gtest.h>

#include <iterator>
#include <string>

#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447_entries_test {
namespace {

constexpr unsigned u8 = 0x05, u16 = 0x06, u24 = 0x16, u32 = 0x07, u64 = 0x1B;  // CiA 301, 7.4.7
constexpr unsigned domain = 0x0F, text = 0x7B;
constexpr std::int64_t none = -1;
constexpr const char* highest = "M Highest sub-index supported";

struct Expected {
  unsigned index;
  unsigned sub;
  unsigned type;
  const char* access;  ///< ro/rw: of the functional server, and of the functional client
  const char* pdo;
  std::int64_t initial;   ///< of ro/rw that of the client; none: the device's, or the maker's
  const char* name = "";  ///< of array and record entries, after M for mandatory and O for optional
};
constexpr Expected entries[] = {
    {0x6005, 0, u8, "ro/rw", "default", 0xFF},
    {0x6006, 0, u8, "rw", "no", 0xFF},
    {0x6007, 0, u8, "ro/rw", "default", 0xFF},
    {0x6009, 0, u8, "ro/rw", "default", 0xFF},
    {0x600A, 0, u8, "rw", "no", 0xFF},
    {0x600B, 0, u24, "ro/rw", "default", 0xFFFFFF},
    {0x600C, 0, u16, "rw", "no", 0xFFFF},
    {0x600D, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x600E, 0, u8, "rw", "no", 0xFF},
    {0x6010, 0, u24, "ro/rw", "default", 0xFFFFFF},
    {0x6011, 0, u16, "rw", "no", 0xFFFF},
    {0x6018, 0, u8, "ro", "no", 0x02, highest},
    {0x6018, 1, u24, "rw", "no", 0xFFFFFF, "M Seat adjustment command driver"},
    {0x6018, 2, u24, "rw", "no", 0xFFFFFF, "M Seat adjustment command front passenger"},
    {0x6019, 0, u8, "ro", "no", 0x02, highest},
    {0x6019, 1, u24, "ro/rw", "default", 0xFFFFFF, "M Seat adjustment status driver"},
    {0x6019, 2, u24, "ro/rw", "default", 0xFFFFFF, "M Seat adjustment status front passenger"},
    {0x601A, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x601B, 0, u16, "rw", "no", 0xFFFF},  // A5
    {0x601C, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x601D, 0, u8, "ro/rw", "default", 0xFF},
    {0x6020, 0, u8, "ro/rw", "no", 0xFF},
    {0x6021, 0, u8, "ro/rw", "no", 0xFF},
    {0x6025, 0, u16, "rw", "no", 0xFFFF},
    {0x6026, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x6027, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x6028, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x602B, 0, text, "ro/rw", "no", none},
    {0x602C, 0, u8, "rw", "no", 0xFF},
    {0x602D, 0, u8, "ro/rw", "no", 0xFF},
    {0x6030, 0, u8, "ro/rw", "default", 0xFF},
    {0x6031, 0, u8, "ro/rw", "default", 0xFF},
    {0x6032, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x6033, 0, u8, "ro/rw", "default", 0xFF},
    {0x6040, 0, u32, "ro/rw", "default", 0xFFFFFFFF},
    {0x6044, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x6045, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x6046, 0, u16, "rw", "no", 0xFFFF},
    {0x6047, 0, u8, "ro/rw", "default", 0xFF},
    {0x6048, 0, u8, "rw", "no", 0xFF},
    {0x6049, 0, u8, "ro/rw", "default", 0xFF},
    {0x604A, 0, u8, "ro/rw", "default", 0xFF},
    {0x604B, 0, u8, "rw", "no", 0xFF},
    {0x604C, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x604D, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x6050, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x6051, 0, u8, "ro/rw", "default", 0xFF},
    {0x6052, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x6053, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x6054, 0, u8, "ro/rw", "no", 0xFF},
    {0x6055, 0, u24, "ro/rw", "default", 0xFFFFFF},
    {0x6056, 0, u24, "ro/rw", "no", 0xFFFFFF},
    {0x6057, 0, u8, "ro/rw", "no", 0xFF},
    {0x605A, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x605B, 0, u24, "ro/rw", "no", 0xFFFFFF},
    {0x605C, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x605D, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x6060, 0, u16, "rw", "no", 0xFFFF},
    {0x6061, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x6062, 0, u8, "rw", "no", 0xFF},
    {0x6063, 0, u8, "ro/rw", "no", 0xFF},
    {0x6069, 0, u8, "ro/rw", "default", 0xFF},
    {0x606C, 0, u8, "ro/rw", "default", 0xFF},
    {0x6070, 0, u8, "ro/rw", "default", 0xFF},
    {0x6071, 0, u8, "rw", "no", 0xFF},
    {0x6073, 0, u8, "ro/rw", "default", 0xFF},
    {0x6074, 0, u8, "rw", "no", 0xFF},
    {0x6078, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x6080, 0, u8, "ro/rw", "default", 0xFF},
    {0x6081, 0, u8, "rw", "no", 0xFF},  // A4
    {0x6082, 0, u8, "ro/rw", "default", 0xFF},
    {0x6085, 0, u8, "ro/rw", "default", 0xFF},
    {0x6086, 0, u8, "rw", "no", 0xFF},
    {0x6087, 0, u8, "ro/rw", "default", 0xFF},
    {0x608A, 0, u8, "ro/rw", "default", 0xFF},
    {0x608B, 0, u8, "rw", "no", 0xFF},
    {0x608C, 0, u8, "ro/rw", "default", 0xFF},
    {0x6090, 0, u8, "ro/rw", "default", 0xFF},
    {0x6091, 0, u8, "rw", "no", 0xFF},
    {0x6092, 0, u8, "ro/rw", "default", 0xFF},
    {0x6093, 0, u8, "ro/rw", "default", 0xFF},
    {0x6094, 0, u8, "rw", "no", 0xFF},
    {0x6095, 0, u8, "ro/rw", "default", 0xFF},
    {0x6096, 0, u8, "ro", "no", 0x03, highest},
    {0x6096, 1, u8, "ro/rw", "no", 0xFF, "M Line number"},
    {0x6096, 2, u8, "ro/rw", "no", 0xFF, "M Column number"},
    {0x6096, 3, u8, "ro/rw", "no", 0xFF, "M Maximal character number"},
    {0x6097, 0, u8, "ro/rw", "default", 0xFF},
    {0x6098, 0, u8, "rw", "no", 0xFF},
    {0x6099, 0, text, "ro/rw", "no", none},
    {0x609A, 0, text, "ro/rw", "no", none},
    {0x609B, 0, u8, "ro", "no", 0x03, highest},
    {0x609B, 1, u8, "ro/rw", "no", 0xFF, "M Line number"},
    {0x609B, 2, u8, "ro/rw", "no", 0xFF, "M Column number"},
    {0x609B, 3, u8, "ro/rw", "no", 0xFF, "M Maximal character number"},
    {0x609C, 0, u8, "ro/rw", "default", 0xFF},
    {0x609D, 0, u8, "rw", "no", 0xFF},
    {0x609E, 0, text, "ro/rw", "no", none},
    {0x60A0, 0, u8, "rw", "no", 0xFF},
    {0x60A1, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60A2, 0, u16, "rw", "no", 0xFFFF},
    {0x60A6, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60A6, 1, u16, "rw", "no", 0xFFFF, "M Icon 1 command"},
    {0x60A6, 2, u16, "rw", "no", 0xFFFF, "O Icon 2 command"},
    {0x60A6, 3, u16, "rw", "no", 0xFFFF, "O Icon 3 command"},
    {0x60A6, 4, u16, "rw", "no", 0xFFFF, "O Icon 4 command"},
    {0x60A7, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60A7, 1, u16, "ro/rw", "no", 0xFFFF, "M Icon 1 status"},
    {0x60A7, 2, u16, "ro/rw", "no", 0xFFFF, "O Icon 2 status"},
    {0x60A7, 3, u16, "ro/rw", "no", 0xFFFF, "O Icon 3 status"},
    {0x60A7, 4, u16, "ro/rw", "no", 0xFFFF, "O Icon 4 status"},
    {0x60AA, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60AA, 1, u16, "rw", "no", 0xFFFF, "M Icon 1 command"},
    {0x60AA, 2, u16, "rw", "no", 0xFFFF, "O Icon 2 command"},
    {0x60AA, 3, u16, "rw", "no", 0xFFFF, "O Icon 3 command"},
    {0x60AA, 4, u16, "rw", "no", 0xFFFF, "O Icon 4 command"},
    {0x60AB, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60AB, 1, u16, "ro/rw", "no", 0xFFFF, "M Icon 1 status"},
    {0x60AB, 2, u16, "ro/rw", "no", 0xFFFF, "O Icon 2 status"},
    {0x60AB, 3, u16, "ro/rw", "no", 0xFFFF, "O Icon 3 status"},
    {0x60AB, 4, u16, "ro/rw", "no", 0xFFFF, "O Icon 4 status"},
    {0x60B0, 0, u8, "ro", "no", 0x02, highest},
    {0x60B0, 1, u32, "ro/rw", "default", 0xFFFFFFFF, "M Position latitude"},
    {0x60B0, 2, u32, "ro/rw", "default", 0xFFFFFFFF, "M Position longitude"},
    {0x60B1, 0, u8, "ro/rw", "no", 0xFF},
    {0x60B2, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60B3, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60B4, 0, u24, "ro/rw", "no", 0xFFFFFF},
    {0x60B5, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60B5, 1, u16, "ro/rw", "no", 0xFFFF, "M GPS velocity"},
    {0x60B5, 2, u16, "ro/rw", "no", 0xFFFF, "O GPS heading"},
    {0x60B6, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x60C0, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x60C1, 0, u8, "ro", "no", 0x02, highest},
    {0x60C1, 1, u32, "rw", "no", 0xFFFFFFFF, "M Position latitude"},
    {0x60C1, 2, u32, "rw", "no", 0xFFFFFFFF, "M Position longitude"},
    {0x60C2, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60C2, 1, text, "ro/rw", "no", none, "M City"},
    {0x60C2, 2, text, "ro/rw", "no", none, "M Street"},
    {0x60C2, 3, text, "ro/rw", "no", none, "O Country"},
    {0x60C3, 0, u8, "ro", "no", 0x03, highest},
    {0x60C3, 1, u32, "rw", "no", 0xFFFFFFFF, "M Position latitude"},
    {0x60C3, 2, u32, "rw", "no", 0xFFFFFFFF, "M Position longitude"},
    {0x60C3, 3, u8, "rw", "no", 0xFF, "M Start guidance"},
    {0x60C4, 0, u8, "rw", "no", 0xFF},
    {0x60C5, 0, u8, "ro", "no", none, highest},  // Z20
    {0x60C5, 1, text, "ro/rw", "no", none, "M City"},
    {0x60C5, 2, text, "ro/rw", "no", none, "M Street"},
    {0x60C5, 3, text, "ro/rw", "no", none, "O Country"},
    {0x60D0, 0, u8, "const", "no", none, highest},
    {0x60D0, 1, u32, "ro/rw", "no", 0xFFFFFFFF, "M Trip fare"},
    {0x60D0, 2, u32, "ro/rw", "no", 0xFFFFFFFF, "M Trip supplement charge"},
    {0x60D0, 3, u32, "ro/rw", "no", 0xFFFFFFFF, "M Total charged"},
    {0x60D0, 4, u32, "ro/rw", "no", 0xFFFFFFFF, "O Trip fare calculation mode"},
    {0x60D0, 5, u32, "ro/rw", "no", 0xFFFFFFFF, "O Trip minimum fare"},
    {0x60D0, 6, u32, "ro/rw", "no", 0xFFFFFFFF, "O Trip initial fare"},
    {0x60D1, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60D2, 0, u8, "const", "no", none, highest},
    {0x60D2, 1, u32, "ro/rw", "no", 0xFFFFFFFF, "M Trip duration"},
    {0x60D2, 2, u32, "ro/rw", "no", 0xFFFFFFFF, "O Fare relevant waiting time"},
    {0x60D2, 3, u32, "ro/rw", "no", 0xFFFFFFFF, "O Trip start time"},
    {0x60D2, 4, u32, "ro/rw", "no", 0xFFFFFFFF, "O Trip finish time"},
    {0x60D3, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x60D4, 0, u8, "const", "no", 0x02, highest},  // Z18
    {0x60D4, 1, u32, "ro/rw", "no", 0xFFFFFFFF, "M Time tariff value"},
    {0x60D4, 2, u32, "ro/rw", "no", 0xFFFFFFFF, "M Distance tariff value"},
    {0x60D8, 0, u8, "ro/rw", "default", 0xFF},
    {0x60D9, 0, u8, "const", "no", none, highest},
    {0x60D9, 1, u32, "ro/rw", "no", 0xFFFFFFFF, "M Total distance travelled"},
    {0x60D9, 2, u32, "ro/rw", "no", 0xFFFFFFFF, "O Shift distance travelled"},
    {0x60D9, 3, u32, "ro/rw", "no", 0xFFFFFFFF, "O Total distance when hired"},
    {0x60D9, 4, u32, "ro/rw", "no", 0xFFFFFFFF, "O Shift distance when hired"},
    {0x60D9, 5, u32, "ro/rw", "no", 0xFFFFFFFF, "O Total income"},
    {0x60D9, 6, u32, "ro/rw", "no", 0xFFFFFFFF, "O Shift income"},
    {0x60D9, 7, u32, "ro/rw", "no", 0xFFFFFFFF, "O Total number of hirings"},
    {0x60D9, 8, u32, "ro/rw", "no", 0xFFFFFFFF, "O Shift number of hirings"},
    {0x60D9, 9, u32, "ro/rw", "no", 0xFFFFFFFF, "O Total supplements"},
    {0x60D9, 10, u32, "ro/rw", "no", 0xFFFFFFFF, "O Shift supplements"},
    {0x60D9, 11, u32, "ro/rw", "no", 0xFFFFFFFF, "O Total fare"},
    {0x60D9, 12, u32, "ro/rw", "no", 0xFFFFFFFF, "O Shift fare"},
    {0x60DA, 0, u8, "const", "no", none, highest},
    {0x60DA, 1, u32, "ro/rw", "no", 0xFFFFFFFF,
     "M Constant of the distance signal generator (k value)"},
    {0x60DA, 2, u8, "ro/rw", "no", 0xFF, "M Taximeter mode"},
    {0x60DA, 3, u24, "ro/rw", "no", 0xFFFFFF, "M Identification of the tariff"},
    {0x60DA, 4, text, "ro/rw", "no", none, "O Taxi identifier"},
    {0x60DA, 5, text, "ro/rw", "no", none, "O Calculation of fare"},
    {0x60DA, 6, u32, "ro/rw", "no", 0xFFFFFFFF, "O Date of securing"},  // Z21
    {0x60DA, 7, u24, "ro/rw", "no", 0xFFFFFF, "O Identification of future tariff"},
    {0x60DA, 8, text, "ro/rw", "no", none, "O Actual currency"},
    {0x60DA, 9, text, "ro/rw", "no", none, "O Actual local distance unit"},
    {0x60DB, 0, u8, "ro/rw", "no", 0xFF},
    {0x60E0, 0, u8, "ro/rw", "default", 0xFF},
    {0x60E1, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x60E2, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60E3, 0, u8, "const", "no", none, highest},
    {0x60E3, 1, u8, "ro/rw", "no", 0xFF, "M Maximum number of characters per full line"},
    {0x60E3, 2, u8, "ro/rw", "no", 0xFF, "O Minimum number of characters per full line"},
    {0x60E3, 3, u8, "ro/rw", "no", 0xFF, "O Current number of characters per full line"},
    {0x60E3, 4, u8, "ro/rw", "no", 0xFF, "O Maximum text height"},
    {0x60E3, 5, u8, "ro/rw", "no", 0xFF, "O Minimum text height"},
    {0x60E3, 6, u8, "ro/rw", "no", 0xFF, "O Current text height"},
    {0x60E3, 7, u8, "ro/rw", "no", 0xFF, "O Maximum text width"},
    {0x60E3, 8, u8, "ro/rw", "no", 0xFF, "O Minimum text width"},
    {0x60E3, 9, u8, "ro/rw", "no", 0xFF, "O Current text width"},
    {0x60E4, 0, u8, "const", "no", none, highest},
    {0x60E4, 1, u16, "ro/rw", "no", 0xFFFF, "M Number of dots per line"},
    {0x60E4, 2, u16, "ro/rw", "no", 0xFFFF, "O Number of grayscales"},
    {0x60E4, 3, u16, "ro/rw", "no", 0xFFFF, "O Number of bits per colour channel"},
    {0x60E5, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x60E6, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60E9, 0, u8, "rw", "no", 0xFF},
    {0x60EA, 0, u8, "ro/rw", "no", 0xFF},
    {0x60EB, 0, domain, "rw", "no", none},
    {0x60F0, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60F1, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x60F2, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60F3, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x60F4, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x60F5, 0, text, "ro/rw", "no", none},
    {0x60F9, 0, u64, "ro/rw", "no", none},
    {0x60FA, 0, u8, "ro/rw", "default", 0xFF},
    {0x60FB, 0, text, "ro/rw", "no", none},
    {0x60FC, 0, u8, "ro", "no", 0x02, highest},
    {0x60FC, 1, u32, "ro/rw", "no", 0xFFFFFFFF, "M Driver login time"},
    {0x60FC, 2, u32, "ro/rw", "no", 0xFFFFFFFF, "M Driver logout time"},
    {0x6100, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x6101, 0, u32, "ro/rw", "default", 0xFFFFFFFF},
    {0x6102, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x6103, 0, u32, "ro/rw", "default", 0xFFFFFFFF},
    {0x6104, 0, u32, "ro/rw", "default", 0xFFFFFFFF},
    {0x6105, 0, u32, "ro/rw", "no", 0xFFFFFFFF},
    {0x6106, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x6107, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x6109, 0, u8, "rw", "no", 0xFF},
    {0x610A, 0, u16, "ro/rw", "no", 0xFFFF},
    {0x6110, 0, u16, "ro/rw", "default", 0xFFFF},
    {0x6115, 0, u8, "ro/rw", "default", 0xFF},
    {0x6116, 0, u8, "rw", "no", 0xFF},
    {0x6117, 0, u8, "ro/rw", "default", 0xFF},
    {0x6120, 0, u24, "rw", "no", 0xFFFFFF},
    {0x6121, 0, u16, "rw", "no", 0xFFFF},
    {0x6122, 0, u8, "ro/rw", "no", 0xFF},
    {0x6130, 0, u8, "ro", "no", 0x05, highest},  // Z19
    {0x6130, 1, u32, "rw", "no", 0xFFFFFFFF, "M Light command 1"},
    {0x6130, 2, u32, "rw", "no", 0xFFFFFFFF, "M Light command 2"},
    {0x6130, 3, u32, "rw", "no", 0xFFFFFFFF, "M Light command 3"},
    {0x6130, 4, u32, "rw", "no", 0xFFFFFFFF, "M Light command 4"},
    {0x6130, 5, u32, "rw", "no", 0xFFFFFFFF, "M Light command 5"},
    {0x6131, 0, u8, "ro", "no", 0x05, highest},  // Z19
    {0x6131, 1, u32, "ro/rw", "default", 0xFFFFFFFF, "M Light status 1"},
    {0x6131, 2, u32, "ro/rw", "default", 0xFFFFFFFF, "M Light status 2"},
    {0x6131, 3, u32, "ro/rw", "default", 0xFFFFFFFF, "M Light status 3"},
    {0x6131, 4, u32, "ro/rw", "default", 0xFFFFFFFF, "M Light status 4"},
    {0x6131, 5, u32, "ro/rw", "default", 0xFFFFFFFF, "M Light status 5"},
    {0x6138, 0, u8, "rw", "no", 0xFF},
    {0x6139, 0, u8, "ro/rw", "no", 0xFF},
    {0x613A, 0, u8, "ro", "no", 0x02, highest},
    {0x613A, 1, u32, "rw", "no", 0xFFFFFFFF, "M Sound command 1"},
    {0x613A, 2, u32, "rw", "no", 0xFFFFFFFF, "M Sound command 2"},
    {0x613B, 0, u8, "ro", "no", 0x02, highest},
    {0x613B, 1, u32, "ro/rw", "default", 0xFFFFFFFF, "M Sound status 1"},
    {0x613B, 2, u32, "ro/rw", "default", 0xFFFFFFFF, "M Sound status 2"},
    {0x6140, 0, u32, "rw", "no", 0xFFFFFFFF},
    {0x6141, 0, u32, "ro/rw", "default", 0xFFFFFFFF},
    {0x6150, 0, u8, "ro/rw", "default", 0xFF},
    {0x6151, 0, u8, "rw", "no", 0xFF},
};

std::string name_of(Access access) {
  if (access == Access::const_) return "const";
  return access == Access::rw ? "rw" : access == Access::ro ? "ro" : "";
}
std::string access_of(const EntryInfo& entry) {
  if (entry.consumer_access == Access::none) return name_of(entry.access);
  return name_of(entry.access) + "/" + name_of(entry.consumer_access);
}
std::int64_t initial_of(const EntryInfo& entry) {
  const Default& initial =
      entry.consumer_access == Access::none ? entry.initial : entry.consumer_initial;
  if (entry.consumer_access != Access::none) {
    EXPECT_FALSE(entry.initial) << "the server has no default";
  }
  if (initial.kind == Default::Kind::highest_sub && initial.number == 0) return none;
  return initial ? initial.number : none;
}

TEST(Cia447Entries, AreThoseOfTheSpecificationAndNoOthers) {
  std::size_t position = 0;
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      ASSERT_LT(position, std::size(entries));
      const Expected& expected = entries[position++];
      SCOPED_TRACE(testing::Message() << std::hex << expected.index << "h:" << expected.sub);
      EXPECT_EQ(object->index, expected.index);
      EXPECT_EQ(entry.sub_first, expected.sub);
      EXPECT_EQ(entry.last_sub(), expected.sub);
      EXPECT_EQ(static_cast<unsigned>(entry.type), expected.type);
      EXPECT_EQ(access_of(entry), expected.access);
      EXPECT_EQ(entry.mapping == Mapping::by_default ? "default" : "no", std::string(expected.pdo));
      EXPECT_NE(entry.mapping, Mapping::optional);
      EXPECT_EQ(initial_of(entry), expected.initial);
      const std::string category = entry.category == Category::mandatory ? "M " : "O ";
      if (*expected.name != 0) {
        EXPECT_EQ(category + std::string(entry.name), expected.name);
      }
    }
  }
  EXPECT_EQ(position, std::size(entries));
}

TEST(Cia447Entries, HaveAsManySubIndicesAsTheSpecificationAllows) {
  struct Range {
    unsigned index;
    std::int64_t low;
    std::int64_t high;
  };
  constexpr Range ranges[] = {{0x6018, 2, 2}, {0x6019, 2, 2},  {0x6096, 3, 3}, {0x609B, 3, 3},
                              {0x60A6, 1, 4}, {0x60A7, 1, 4},  {0x60AA, 1, 4}, {0x60AB, 1, 4},
                              {0x60B0, 2, 2}, {0x60B5, 1, 2},  {0x60C1, 2, 2}, {0x60C2, 2, 3},
                              {0x60C3, 3, 3}, {0x60C5, 2, 3},  {0x60D0, 3, 6}, {0x60D2, 1, 4},
                              {0x60D4, 2, 2}, {0x60D9, 1, 12}, {0x60DA, 3, 9}, {0x60E3, 1, 9},
                              {0x60E4, 1, 3}, {0x60FC, 2, 2},  {0x6130, 5, 5}, {0x6131, 5, 5},
                              {0x613A, 2, 2}, {0x613B, 2, 2}};
  std::size_t found = 0;
  for (const Range& range : ranges) {
    SCOPED_TRACE(testing::Message() << std::hex << range.index << "h");
    const ObjectInfo* object = find_object(cia447::profile, range.index);
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(object->subs[0].value.limits.low, range.low);
    EXPECT_EQ(object->subs[0].value.limits.high, range.high);
    EXPECT_EQ(object->subs.size(), static_cast<std::size_t>(range.high) + 1);
  }
  for (const ObjectInfo* object : cia447::profile.objects) found += object->subs.empty() ? 0U : 1U;
  EXPECT_EQ(found, std::size(ranges));
}

TEST(Cia447Entries, TextsHoldAsManyCharactersAsTheSpecificationSays) {
  EXPECT_EQ(cia447::vin_data_object.entry.capacity, 17);
  EXPECT_GE(cia447::rtc_time_zone_object.entry.capacity, 6);
  EXPECT_GE(cia447::display_1_text_object.entry.capacity, 254);
}

}  // namespace
}  // namespace canvoy::cia447_entries_test
